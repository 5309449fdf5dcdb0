package org.dfra.river.callback;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.lang.reflect.Proxy;
import java.rmi.Remote;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.http.HttpEndpoint;
import org.dfra.event.delivery.DeliveryPool;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.callback.CallbackLimiter.CallbackSlot;
import org.dfra.river.fixture.SteppedTime;
import org.dfra.river.remote.RemoteModuleListener;
import org.junit.jupiter.api.Test;

/** A client has only so many processes that are called back; nothing is called here. */
class CallbackLimiterTest {

  private static final ClientAddress STRANGER = ClientAddress.of("127.1.1.66", "127.1.1.10");
  private static final ClientAddress OTHER = ClientAddress.of("127.1.1.67", "127.1.1.10");

  /** Of an address. */
  private static final int PROCESSES = 12;

  private static final Duration LINGER = Duration.ofSeconds(36);

  private final SteppedTime time = new SteppedTime();
  private final CallbackLimiter peers = new CallbackLimiter(new DeliveryPool(1, time), time);

  /** A listener in the process that listens at this port. */
  private static Remote listener(int port) {
    return (Remote)
        DeadlineILFactory.proxy(
            new BasicObjectEndpoint(
                Endpoints.tcpClient("127.1.1.66", port), UuidFactory.generate(), false),
            Duration.ofHours(2),
            RemoteModuleListener.class.getClassLoader(),
            RemoteModuleListener.class);
  }

  private List<CallbackSlot> admitProcesses(ClientAddress client, int firstPort, int count)
      throws CallbackRefusedException {
    List<CallbackSlot> places = new ArrayList<>();
    for (int port = firstPort; port < firstPort + count; port++) {
      places.add(peers.admit(client, listener(port)));
    }
    return places;
  }

  @Test
  void manyListenersOfOneProcessAreOneProcess() throws Exception {
    for (int i = 0; i < 100; i++) {
      assertThat(peers.admit(STRANGER, listener(7001)).lane()).isNotNull();
    }
    assertThat(peers.processCount()).isEqualTo(1);
  }

  @Test
  void oneProcessTooManyIsRefusedAndTheOtherAddressIsNot() throws Exception {
    assertThat(admitProcesses(STRANGER, 7001, PROCESSES)).hasSize(PROCESSES);
    assertThatExceptionOfType(CallbackRefusedException.class)
        .isThrownBy(() -> peers.admit(STRANGER, listener(7100)))
        .withMessageStartingWith(
            "processes that are called back from here: 127.1.1.66 holds 12 of at most 12");
    assertThat(peers.admit(STRANGER, listener(7001))).as("a known process").isNotNull();
    assertThat(peers.admit(OTHER, listener(7100))).as("another address").isNotNull();
  }

  @Test
  void whatNoDeadlineBoundsIsCalledBackOnThisComputerOnly() throws Exception {
    Class<?>[] kind = {RemoteModuleListener.class};
    ClassLoader loader = RemoteModuleListener.class.getClassLoader();
    Remote itsOwnWay =
        (Remote) Proxy.newProxyInstance(loader, kind, (proxy, method, arguments) -> null);
    Remote byHttp =
        (Remote)
            DeadlineILFactory.proxy(
                new BasicObjectEndpoint(
                    HttpEndpoint.getInstance("127.1.1.66", 7001), UuidFactory.generate(), false),
                Duration.ofSeconds(1),
                loader,
                kind);
    for (Remote listener : List.of(itsOwnWay, byHttp)) {
      assertThatExceptionOfType(CallbackRefusedException.class)
          .isThrownBy(() -> peers.admit(STRANGER, listener))
          .withMessageContaining("127.1.1.66")
          .withMessageContaining("JERI over TCP");
    }
    assertThat(peers.processCount()).isZero();
    ClientAddress own = ClientAddress.of("127.0.0.1", "127.1.1.10");
    assertThat(peers.admit(own, byHttp)).isNotNull();
  }

  @Test
  void aProcessThatIsNotCalledAnyMoreMakesRoomOnceItsConnectionIsGone() throws Exception {
    List<CallbackSlot> places = admitProcesses(STRANGER, 7001, PROCESSES);
    places.forEach(CallbackSlot::close);
    places.forEach(CallbackSlot::close);
    assertThat(peers.processCount()).as("their connections linger").isEqualTo(PROCESSES);
    assertThatExceptionOfType(CallbackRefusedException.class)
        .isThrownBy(() -> peers.admit(STRANGER, listener(7100)));
    time.pass(LINGER);
    assertThat(peers.processCount()).isZero();
    assertThat(admitProcesses(STRANGER, 7100, PROCESSES)).hasSize(PROCESSES);
  }

  @Test
  void aProcessThatComesAndGoesAllTheTimeCostsOneTask() throws Exception {
    for (int i = 0; i < 1000; i++) {
      peers.admit(STRANGER, listener(7001)).close();
    }
    assertThat(time.waiting()).isEqualTo(1);
    time.pass(LINGER.dividedBy(2));
    peers.admit(STRANGER, listener(7001)).close();
    time.pass(LINGER.dividedBy(2).plusSeconds(1));
    assertThat(peers.processCount()).as("it was called meanwhile").isEqualTo(1);
    time.pass(LINGER);
    assertThat(peers.processCount()).isZero();
    assertThat(time.waiting()).isZero();
  }
}
