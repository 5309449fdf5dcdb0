package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import net.jini.core.event.RemoteEventListener;
import net.jini.export.ServerContext;
import net.jini.id.UuidFactory;
import net.jini.io.context.ClientHost;
import net.jini.jeri.BasicObjectEndpoint;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.callback.CallbackPeersFixture;
import org.dfra.river.fixture.SteppedTime;
import org.junit.jupiter.api.Test;

/** Listeners hold the places of their processes while they are registered; none is called here. */
class RegistrarListenersTest {

  private static final String ROBOT = "127.1.1.10";
  private static final String STRANGER = "127.1.1.66";

  /** Of an address. */
  private static final int PROCESSES = 12;

  /** Longer than the place of a process that is not called any more is kept. */
  private static final Duration LINGER = Duration.ofSeconds(36);

  private final SteppedTime time = new SteppedTime();
  private final EventListenerPreparer listeners =
      new EventListenerPreparer(ROBOT, CallbackPeersFixture.by(time));

  /** A listener in the stranger's process that listens at this port. */
  private static RemoteEventListener listener(int port) {
    return (RemoteEventListener)
        DeadlineILFactory.proxy(
            new BasicObjectEndpoint(
                Endpoints.tcpClient(STRANGER, port), UuidFactory.generate(), false),
            Duration.ofSeconds(2),
            RemoteEventListener.class.getClassLoader(),
            RemoteEventListener.class);
  }

  /** The stranger registers a listener; what the lookup service holds in its place. */
  private Object register(int port) throws UnknownHostException {
    InetAddress stranger = InetAddress.getByName(STRANGER);
    AtomicReference<Object> prepared = new AtomicReference<>();
    ServerContext.doWithServerContext(
        () -> {
          try {
            prepared.set(listeners.prepareProxy(listener(port)));
          } catch (RemoteException e) {
            throw new AssertionError("nothing is to be called", e);
          }
        },
        List.of((ClientHost) () -> stranger));
    return prepared.get();
  }

  private void registerProcesses(int firstPort, int count) throws UnknownHostException {
    for (int port = firstPort; port < firstPort + count; port++) {
      assertThat(register(port)).isInstanceOf(RegistrarListener.class);
    }
  }

  private void assertIsFull(int port) {
    assertThatThrownBy(() -> register(port))
        .isInstanceOf(SecurityException.class)
        .hasMessageContaining(STRANGER + " holds " + PROCESSES + " of at most " + PROCESSES);
  }

  @Test
  void processesOfListenersThatAreNotRegisteredAnyMoreMakeRoomForOthers() throws Exception {
    listeners.startTracking();
    Object kept = register(7001);
    registerProcesses(7002, PROCESSES - 1);
    assertIsFull(7100);

    listeners.retain(Set.of(kept));
    time.pass(LINGER);
    assertIsFull(7100); // each may have been on its way to its registration
    listeners.retain(Set.of(kept));
    time.pass(LINGER);

    registerProcesses(7100, PROCESSES - 1);
    assertIsFull(7200); // one place is that of the listener that is still registered
  }
}
