package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import net.jini.core.event.RemoteEvent;
import net.jini.core.event.RemoteEventListener;
import net.jini.core.event.UnknownEventException;
import net.jini.export.Exporter;
import net.jini.export.ServerContext;
import net.jini.id.UuidFactory;
import net.jini.io.context.ClientHost;
import net.jini.jeri.BasicILFactory;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.InvocationLayerFactory;
import net.jini.jeri.tcp.TcpServerEndpoint;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.callback.CallbackPeersFixture;
import org.dfra.river.fixture.SteppedTime;
import org.junit.jupiter.api.Test;

/** Listeners hold the places of their processes while they are registered, and their threads. */
class EventListenerPreparerTest {

  private static final String ROBOT = "127.1.1.10";
  private static final String STRANGER = "127.1.1.66";
  private static final String LOOPBACK = "127.0.0.1";

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

  /** The stranger registers a listener in the process at this port, which is not called. */
  private Object register(int port) throws UnknownHostException {
    return register(listener(port));
  }

  /** The stranger registers a listener; what the lookup service holds in its place. */
  private RemoteEventListener register(RemoteEventListener listener) throws UnknownHostException {
    InetAddress stranger = InetAddress.getByName(STRANGER);
    AtomicReference<RemoteEventListener> prepared = new AtomicReference<>();
    ServerContext.doWithServerContext(
        () -> {
          try {
            prepared.set((RemoteEventListener) listeners.prepareProxy(listener));
          } catch (RemoteException e) {
            throw new AssertionError("nothing is to be called", e);
          }
        },
        List.of((ClientHost) () -> stranger));
    return prepared.get();
  }

  private void registerProcesses(int firstPort, int count) throws UnknownHostException {
    for (int port = firstPort; port < firstPort + count; port++) {
      assertThat(register(port)).isInstanceOf(QueuedEventListener.class);
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

  @Test
  void aListenerThatDoesNotAnswerHoldsItsThreadForOurDeadlineOnly() throws Exception {
    CountDownLatch end = new CountDownLatch(1);
    CountDownLatch received = new CountDownLatch(1);
    RemoteEventListener silent = event -> blockUntil(end); // JERI holds both weakly
    RemoteEventListener answering = event -> received.countDown();
    Exporter ofHours = exporter(new DeadlineILFactory(Duration.ofHours(2).toMillis()));
    Exporter usual = exporter(new BasicILFactory());
    try {
      RemoteEventListener first = register((RemoteEventListener) ofHours.export(silent));
      RemoteEventListener second = register((RemoteEventListener) usual.export(answering));
      CompletableFuture<Void> notified =
          CompletableFuture.runAsync(
              () -> {
                notify(first); // in the pool of this test, on the caller's thread
                notify(second);
              });
      assertThat(received.await(30, TimeUnit.SECONDS))
          .as("the second listener is called once the first one's call has ended")
          .isTrue();
      notified.get(30, TimeUnit.SECONDS);
    } finally {
      end.countDown();
      boolean unused = usual.unexport(true) && ofHours.unexport(true);
    }
    assertThat(List.of(silent, answering)).isNotEmpty();
  }

  private static Exporter exporter(InvocationLayerFactory factory) {
    return new BasicJeriExporter(TcpServerEndpoint.getInstance(LOOPBACK, 0), factory, false, false);
  }

  private static void notify(RemoteEventListener listener) {
    try {
      listener.notify(new RemoteEvent("source", 1, 1, null));
    } catch (UnknownEventException | RemoteException e) {
      throw new AssertionError(e);
    }
  }

  private static void blockUntil(CountDownLatch end) {
    try {
      end.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
