package org.dfra.river.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dfra.river.fixture.TimerTasks;
import org.dfra.river.loading.HttpListener.HttpResponder;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Clients of an {@link HttpListener} that do not take their answers. */
@Timeout(60)
class HttpListenerTest {

  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  /** Within which an answer must have been taken. */
  private static final Duration ANSWER = Duration.ofSeconds(60);

  private static final Duration PATIENCE = Duration.ofSeconds(10);

  private static final byte[] REQUEST =
      "GET /big.jar HTTP/1.1\r\n\r\n".getBytes(StandardCharsets.US_ASCII);

  /** More than the buffers of a connection hold. */
  private final byte[] big = new byte[16 << 20];

  private final List<Socket> sockets = new ArrayList<>();
  private HttpListener listener;

  @BeforeEach
  void listen() throws IOException {
    listener =
        HttpListener.start(
            new InetSocketAddress(LOOPBACK, 0),
            path -> new HttpResponder.HttpReply(200, Map.of(), big));
  }

  @AfterEach
  void close() throws IOException {
    for (Socket each : sockets) {
      each.close();
    }
    listener.close();
  }

  /** Sends a request; whether its answer begins. No more of that is taken. */
  private boolean isAnswered() throws IOException {
    Socket socket = new Socket();
    sockets.add(socket);
    socket.setReceiveBufferSize(4096); // so that little of an answer is on its way
    socket.connect(new InetSocketAddress(LOOPBACK, listener.port()));
    socket.setSoTimeout(30_000);
    try {
      socket.getOutputStream().write(REQUEST);
      return socket.getInputStream().read() == 'H';
    } catch (SocketException e) { // reset, since there is no place for it
      return false;
    }
  }

  @Test
  void clientsThatDoNotTakeTheirAnswersInTimeLoseTheirPlaces() throws Exception {
    for (int i = 0; i < HttpListener.PER_ADDRESS; i++) {
      assertThat(isAnswered()).as("request %d", i).isTrue();
    }
    assertThat(isAnswered()).as("one too many of an address").isFalse();

    TimerTasks.runDue(listener.deadlines, ANSWER);

    await("a free place").atMost(PATIENCE).until(this::isAnswered);
  }
}
