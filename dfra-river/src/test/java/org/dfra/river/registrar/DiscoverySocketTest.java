package org.dfra.river.registrar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dfra.river.fixture.TimerTasks;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Connections for discovery end by themselves, whatever the other side does. */
@Timeout(60)
class DiscoverySocketTest {

  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  /** How long a connection may last. */
  private static final Duration LIFE = Duration.ofSeconds(5);

  /** How long an end that has come may take to arrive. */
  private static final int PATIENCE_MILLIS = 10_000;

  /** A connection that the system takes is made at once. */
  private static final int FULL_MILLIS = 300;

  /** More connections than the system keeps for a backlog of one. */
  private static final int MANY = 16;

  private final List<Socket> sockets = new ArrayList<>();

  @AfterEach
  void close() throws IOException {
    for (Socket each : sockets) {
      each.close();
    }
  }

  private static void assertIsEnded(Socket socket) throws IOException {
    socket.setSoTimeout(PATIENCE_MILLIS);
    assertThat(socket.getInputStream().read()).as("the end of the connection").isEqualTo(-1);
  }

  @Test
  void theConnectionOfAClientThatSendsNothingEndsByItself() throws Exception {
    String host = LOOPBACK.getHostAddress();
    try (ServerSocket server = new DiscoveryServerSocketFactory(host).createServerSocket(0);
        Socket client = new Socket(LOOPBACK, server.getLocalPort())) {
      sockets.add(server.accept());
      TimerTasks.runDue(DiscoverySocket.ENDS, LIFE);
      assertIsEnded(client);
    }
  }

  @Test
  void theConnectionToAClientThatTakesNoAnswerEndsByItself() throws Exception {
    try (ServerSocket client = new ServerSocket(0, 1, LOOPBACK)) {
      sockets.add(
          new DiscoveryResponseSocketFactory().createSocket(LOOPBACK, client.getLocalPort()));
      try (Socket accepted = client.accept()) {
        TimerTasks.runDue(DiscoverySocket.ENDS, LIFE);
        assertIsEnded(accepted);
      }
    }
  }

  /** Else it fails in another way, after two minutes. */
  @Test
  void aClientThatCannotBeConnectedToIsGivenUpSoon() throws Exception {
    try (ServerSocket full = new ServerSocket(0, 1, LOOPBACK)) {
      assumeTrue(isFilled(full), "the system takes any number of connections");
      DiscoveryResponseSocketFactory answering = new DiscoveryResponseSocketFactory();
      assertThatThrownBy(() -> sockets.add(answering.createSocket(LOOPBACK, full.getLocalPort())))
          .isInstanceOf(SocketTimeoutException.class);
    }
  }

  /** Connects until the system drops what asks for a further connection. */
  private boolean isFilled(ServerSocket server) throws IOException {
    for (int i = 0; i < MANY; i++) {
      Socket socket = new Socket();
      sockets.add(socket);
      try {
        socket.connect(server.getLocalSocketAddress(), FULL_MILLIS);
      } catch (SocketTimeoutException e) {
        return true;
      }
    }
    return false;
  }
}
