package org.dfra.drivers.link;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static java.util.concurrent.TimeUnit.SECONDS;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.dfra.drivers.fixture.Modules;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(120)
class TcpLinkTest {

  private static final Duration LONG = Duration.ofSeconds(40);

  private ServerSocket server;
  private Socket peer;
  private SerialLink link;
  private final byte[] buffer = new byte[64];

  @BeforeEach
  void connect() throws IOException {
    server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
    link = LinkAddress.open("tcp://127.0.0.1:" + server.getLocalPort());
    peer = server.accept();
  }

  @AfterEach
  void disconnect() throws IOException {
    link.close();
    peer.close();
    server.close();
  }

  @Test
  void carriesBytesBothWays() throws IOException {
    peer.getOutputStream().write("fix".getBytes(US_ASCII));
    int count = link.read(buffer, 5, 10, LONG);
    assertThat(new String(buffer, 5, count, US_ASCII)).isEqualTo("fix");
    link.write("poll".getBytes(US_ASCII));
    assertThat(new String(peer.getInputStream().readNBytes(4), US_ASCII)).isEqualTo("poll");
    assertThat(link).hasToString("tcp://127.0.0.1:" + server.getLocalPort());
  }

  @Test
  void returnsZeroWhenNothingComesInTimeAndGoesOn() throws IOException {
    assertThat(link.read(buffer, 0, 10, Duration.ofMillis(5))).isZero();
    assertThat(link.read(buffer, 0, 10, Duration.ZERO)).isZero();
    assertThat(link.isOpen()).isTrue();
    peer.getOutputStream().write(7);
    assertThat(link.read(buffer, 0, 10, LONG)).isOne();
  }

  @Test
  void reportsThatThePeerHasGone() throws IOException {
    peer.close();
    assertThat(link.read(buffer, 0, 10, LONG)).isEqualTo(-1);
    assertThat(link.isOpen()).isFalse();
    assertThat(link.read(buffer, 0, 10, LONG)).isEqualTo(-1);
    assertThatThrownBy(() -> link.write(new byte[1]))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("the connection is lost");
  }

  @Test
  void reportsThatThePeerHasReset() throws IOException {
    peer.setSoLinger(true, 0);
    peer.close();
    assertThat(link.read(buffer, 0, 10, LONG)).isEqualTo(-1);
  }

  @Test
  void closeFreesAWaitingReaderAtOnce() throws Exception {
    CompletableFuture<Thread> reading = new CompletableFuture<>();
    CompletableFuture<Integer> read =
        CompletableFuture.supplyAsync(
            () -> {
              reading.complete(Thread.currentThread());
              return link.read(buffer, 0, 10, Duration.ofHours(1));
            });
    Thread reader = reading.get(40, SECONDS);
    Modules.await().until(() -> isInside(reader, "TcpLink", "read"));
    link.close();
    assertThat(read.get(40, SECONDS)).isEqualTo(-1);
    link.close(); // once more does nothing
  }

  @Test
  void saysWhatItCouldNotConnectTo() throws IOException {
    int port = server.getLocalPort();
    server.close();
    assertThatThrownBy(() -> LinkAddress.open("tcp://127.0.0.1:" + port))
        .isInstanceOf(IOException.class)
        .hasMessageStartingWith("tcp://127.0.0.1:" + port + ": no connection within 2 s (")
        .hasMessageEndingWith("is the device's server running, and on this port?");
    assertThatThrownBy(() -> LinkAddress.open("tcp://no-such-host.invalid:1"))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("the host name no-such-host.invalid is not known");
  }

  @Test
  void anInterruptEndsTheAttemptToConnect() throws Exception {
    try (ServerSocket full = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      List<Socket> queued = new ArrayList<>();
      try {
        while (true) { // fill its queue; from then on nobody answers
          Socket next = new Socket();
          queued.add(next);
          next.connect(full.getLocalSocketAddress(), 200);
        }
      } catch (SocketTimeoutException expected) {
        CompletableFuture<Throwable> end = new CompletableFuture<>();
        Thread opener =
            new Thread(
                () -> {
                  try (SerialLink unexpected =
                      LinkAddress.open("tcp://127.0.0.1:" + full.getLocalPort())) {
                    end.complete(new AssertionError(unexpected + " was opened"));
                  } catch (IOException e) {
                    end.complete(e);
                  }
                });
        opener.start();
        Modules.await().until(() -> isInside(opener, "TcpLink", "open"));
        opener.interrupt();
        assertThat(end.get(40, SECONDS).getCause())
            .as("interrupted, and not given up after 2 s")
            .isNotNull()
            .isNotInstanceOf(SocketTimeoutException.class);
      } finally {
        for (Socket socket : queued) {
          socket.close();
        }
      }
    }
  }

  private static boolean isInside(Thread thread, String className, String method) {
    for (StackTraceElement element : thread.getStackTrace()) {
      if (element.getClassName().endsWith(className) && element.getMethodName().equals(method)) {
        return true;
      }
    }
    return false;
  }
}
