package org.dfra.river.call;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Future;
import net.jini.jeri.Endpoint;
import net.jini.jeri.ServerEndpoint;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.junit.jupiter.api.Test;

/** Deadlines over River's own transport, which needs a thread for each call. */
class RiverDeadlineTest extends DeadlineContract {

  @Override
  ServerEndpoint endpoint() {
    return Endpoints.river("127.0.0.1", 0);
  }

  @Override
  Endpoint client(int port) {
    return Endpoints.riverClient("127.0.0.1", port);
  }

  @Test
  void peerThatTakesConnectionsAndNeverAnswersIsReportedAndHoldsSoManyThreads() throws Exception {
    ServerSocket mute = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    open.add(mute);
    Service service = proxy(mute.getLocalPort(), 150);
    StallProbe.Stopwatch began = probe.stopwatch();
    assertNotRun(service);
    Timing ended = began.stop();
    List<Future<?>> callers = new ArrayList<>();
    for (int i = 0; i < 40; i++) {
      callers.add(threads.submit(() -> assertNotRun(service)));
    }
    for (Future<?> each : callers) {
      each.get();
    }
    assertThatExceptionOfType(DeadlineExceededException.class)
        .isThrownBy(
            () -> {
              for (int i = 0; i <= UnresponsivePeers.MAX_BLOCKED_THREADS; i++) {
                service.echo("x");
              }
            })
        .satisfies(e -> assertThat(e.mayHaveRun()).isFalse());
    assertThat(export(20_000).echo("other peers")).isEqualTo("other peers");
    // When the peer goes away its threads come free, and it is tried again.
    mute.close();
    ended.requireWithin("a call with a deadline of 150 ms", MARGIN.plusMillis(150));
  }

  @Test
  void peerThatTakesNoConnectionIsReportedInTimeAndItsThreadsAreBounded() throws Exception {
    // A listener whose queue is full: the operating system drops further connections unanswered.
    ServerSocket full = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
    open.add(full);
    for (int i = 0; i < 4; i++) {
      Socket waiting = new Socket();
      open.add(waiting);
      threads.submit(
          () -> {
            waiting.connect(
                new InetSocketAddress(full.getInetAddress(), full.getLocalPort()), 2000);
            return null;
          });
    }
    Service service = proxy(full.getLocalPort(), 20);
    boolean refused = false;
    for (int i = 0; i < 200 && !refused; i++) { // each holds its thread until connecting fails
      StallProbe.Stopwatch began = probe.stopwatch();
      try {
        service.echo("x");
      } catch (DeadlineExceededException e) {
        assertThat(e.mayHaveRun()).isFalse();
        refused = e.getMessage().contains("was not tried");
      }
      began.stop().requireWithin("call " + i + " with a deadline of 20 ms", MARGIN.plusMillis(20));
    }
    assertThat(refused).as("a call was not even tried").isTrue();
    assertThat(export(20_000).echo("other peers")).isEqualTo("other peers");
  }

  @Test
  void connectionToAHostThatTakesNoMoreOfThemIsClosedAfterTheDeadline() throws Exception {
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      Future<?> call = threads.submit(() -> assertNotRun(proxy(server.getLocalPort(), 1500)));
      try (Socket connection = server.accept()) {
        fill(server);
        call.get();
        connection.setSoTimeout(30_000);
        assertThat(connection.getInputStream().readAllBytes())
            .as("what came before the client closed it")
            .isNotEmpty();
      }
    }
  }

  @Test
  void connectionToAProcessThatIsOnlySlowIsLeftAlone() throws Exception {
    try (ServerSocket server = new ServerSocket(0, 50, InetAddress.getLoopbackAddress())) {
      Future<?> call = threads.submit(() -> assertNotRun(proxy(server.getLocalPort(), 200)));
      try (Socket connection = server.accept();
          Socket probe = server.accept()) {
        call.get();
        assertThat(probe.getInputStream().read()).as("nothing is sent").isEqualTo(-1);
        connection.setSoTimeout(500);
        assertThatExceptionOfType(SocketTimeoutException.class)
            .isThrownBy(() -> connection.getInputStream().readAllBytes());
      }
    }
  }

  @Test
  void silentPeersCountUpAndDown() {
    UnresponsivePeers peers = new UnresponsivePeers();
    assertThat(peers.blockedThreads("a")).isZero();
    peers.addBlockedThread("a");
    peers.addBlockedThread("a");
    peers.addBlockedThread("b");
    assertThat(peers.blockedThreads("a")).isEqualTo(2);
    peers.removeBlockedThread("a");
    peers.removeBlockedThread("a");
    peers.removeBlockedThread("a");
    assertThat(peers.blockedThreads("a")).isZero();
    assertThat(peers.blockedThreads("b")).isEqualTo(1);
  }

  @Test
  void threadsThatAPeerHeldAreLetGoWhenItAnswers() throws Exception {
    Service service = export(100);
    for (int i = 0; i < UnresponsivePeers.MAX_BLOCKED_THREADS / 2; i++) {
      assertThatExceptionOfType(DeadlineExceededException.class).isThrownBy(service::block);
    }
    release.countDown();
    await("calls get through again").atMost(PATIENCE).until(() -> works(service));
  }

  /** Until the operating system takes no further connections for the server. */
  private void fill(ServerSocket server) throws IOException {
    while (true) {
      Socket waiting = new Socket();
      open.add(waiting);
      try {
        waiting.connect(server.getLocalSocketAddress(), 300);
      } catch (SocketTimeoutException e) {
        return;
      }
    }
  }
}
