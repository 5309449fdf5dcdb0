package org.dfra.river.discovery;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Anybody may connect where answers to multicast requests are awaited; only a few may wait. */
@Timeout(60)
class ResponseListenerTest {

  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();
  private static final String STRANGER = "127.0.0.66";

  /** Connections of one address that wait. */
  private static final int OF_AN_ADDRESS = 2;

  /** Connections that wait. */
  private static final int IN_ALL = 16;

  private static final int BACKLOG = 50;
  private static final int PATIENCE_MILLIS = 10_000;

  private final BlockingQueue<String> responses = new LinkedBlockingQueue<>();
  private final List<Socket> sockets = new ArrayList<>();
  private ResponseListener listener;

  @BeforeEach
  void listen() throws IOException {
    assumeTrue(isAddressHere(STRANGER), STRANGER + " is no address of this computer");
    listener =
        ResponseListener.start(
            () -> responses.add("one waits"), port -> new ServerSocket(port, BACKLOG, LOOPBACK));
  }

  @AfterEach
  void close() throws IOException {
    for (Socket each : sockets) {
      each.close();
    }
    if (listener != null) {
      listener.close();
    }
  }

  private static boolean isAddressHere(String address) {
    try (ServerSocket bound = new ServerSocket(0, 1, InetAddress.getByName(address))) {
      return bound.isBound();
    } catch (IOException e) {
      return false;
    }
  }

  private Socket connect(String from) throws IOException {
    Socket socket = new Socket();
    sockets.add(socket);
    socket.bind(new InetSocketAddress(from, 0));
    socket.connect(new InetSocketAddress(LOOPBACK, listener.port()));
    return socket;
  }

  /** Awaits that the listener ends it. */
  private static void assertIsEnded(Socket socket) throws IOException {
    socket.setSoTimeout(PATIENCE_MILLIS);
    int read;
    try {
      read = socket.getInputStream().read();
    } catch (SocketException e) { // it was reset
      read = -1;
    }
    assertThat(read).as("the end of the connection").isEqualTo(-1);
  }

  private int countWaiting() throws IOException {
    int count = 0;
    for (Optional<Socket> each = listener.next(); each.isPresent(); each = listener.next()) {
      each.get().close();
      count++;
    }
    return count;
  }

  @Test
  void twoConnectionsOfAnAddressWaitAndFurtherOnesAreClosed() throws Exception {
    for (int i = 0; i < OF_AN_ADDRESS; i++) {
      connect(STRANGER);
    }
    for (int i = 0; i < 3; i++) {
      assertIsEnded(connect(STRANGER));
    }
    assertThat(responses).hasSize(OF_AN_ADDRESS);
    assertThat(countWaiting()).isEqualTo(OF_AN_ADDRESS);
  }

  @Test
  void sixteenConnectionsWaitAndAFurtherOneWhenOneOfThemWasTaken() throws Exception {
    for (int i = 1; i <= IN_ALL; i++) {
      connect("127.0.7." + i);
    }
    for (int i = 1; i <= 4; i++) {
      assertIsEnded(connect("127.0.8." + i));
    }
    assertThat(responses).hasSize(IN_ALL);
    responses.clear();

    listener.next().orElseThrow().close();

    connect("127.0.8.5");
    assertThat(responses.poll(PATIENCE_MILLIS, TimeUnit.MILLISECONDS))
        .as("the place of the one that was taken")
        .isNotNull();
    assertIsEnded(connect("127.0.8.6"));
    assertThat(countWaiting()).isEqualTo(IN_ALL);
  }
}
