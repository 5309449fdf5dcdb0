package org.dfra.river.transport;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.jeri.OutboundRequest;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * A server that the test speaks for sends a part of its response. The connection never serves
 * another call then, and the call may have run.
 */
@Timeout(60)
class HalfReadResponseTest {

  private static final String HOST = "127.0.0.1";
  private static final int REQUEST_BYTES = 3;

  private final List<Peer> peers = new ArrayList<>();
  private final ExecutorService callers = Executors.newCachedThreadPool();
  private ServerSocket server;
  private TransportEndpoint endpoint;

  @BeforeEach
  void listen() throws IOException {
    server = new ServerSocket(0, 5, InetAddress.getByName(HOST));
    endpoint = new TransportEndpoint(HOST, server.getLocalPort());
  }

  @AfterEach
  void close() throws IOException {
    callers.shutdownNow();
    for (Peer each : peers) {
      each.socket.close();
    }
    server.close();
  }

  /** A connection, at the server. */
  private static final class Peer {

    private final Socket socket;
    private final DataInputStream in;
    private final DataOutputStream out;

    Peer(Socket socket) throws IOException {
      this.socket = socket;
      socket.setSoTimeout(30_000);
      this.in = new DataInputStream(socket.getInputStream());
      this.out = new DataOutputStream(socket.getOutputStream());
      in.readFully(new byte[Greeting.CLIENT_BYTES]);
      out.write(Greeting.server(Greeting.Answer.WELCOME).array());
    }

    void awaitRequest() throws IOException {
      assertThat(in.readInt()).isEqualTo(Block.encode(Block.Kind.END, REQUEST_BYTES));
      in.readFully(new byte[REQUEST_BYTES]);
    }

    void send(Block.Kind kind, int length, byte... bytes) throws IOException {
      ByteBuffer block = ByteBuffer.allocate(Block.HEADER_BYTES + bytes.length);
      out.write(block.putInt(Block.encode(kind, length)).put(bytes).array());
    }

    void assertClosedByClient() throws IOException {
      try {
        assertThat(in.read()).as("the end of the connection").isEqualTo(-1);
      } catch (SocketException e) {
        assertThat(e).hasMessageContaining("reset");
      }
    }
  }

  private Future<Peer> accept() {
    return callers.submit(
        () -> {
          Peer peer = new Peer(server.accept());
          peers.add(peer);
          return peer;
        });
  }

  private OutboundRequest send() throws IOException {
    OutboundRequest request = endpoint.newRequest(InvocationConstraints.EMPTY).next();
    try (OutputStream out = request.getRequestOutputStream()) {
      out.write(new byte[REQUEST_BYTES]);
    }
    return request;
  }

  /** A call, and the server's end of its connection. */
  private record Call(OutboundRequest request, Peer peer) {}

  /** Begins a call on a new connection; the server has received its request. */
  private Call begin() throws Exception {
    Future<Peer> accepted = accept();
    OutboundRequest request = send();
    Peer peer = accepted.get(30, TimeUnit.SECONDS);
    peer.awaitRequest();
    return new Call(request, peer);
  }

  /** Whether a call, on whatever connection, gets its own response. */
  private void assertNextCallHasItsOwnConnection() throws Exception {
    Call call = begin();
    OutboundRequest request = call.request();
    Peer peer = call.peer();
    peer.send(Block.Kind.END, 2, (byte) 8, (byte) 9);
    try (InputStream in = request.getResponseInputStream()) {
      assertThat(in.readAllBytes()).containsExactly(8, 9);
    }
  }

  @Test
  void whoClosesAResponseThatIsNotReceivedClosesItsConnection() throws Exception {
    Call call = begin();
    OutboundRequest request = call.request();
    Peer peer = call.peer();
    peer.send(Block.Kind.PART, 4, (byte) 1, (byte) 2, (byte) 3, (byte) 4);
    InputStream in = request.getResponseInputStream();
    assertThat(in.read()).isEqualTo(1);
    in.close();
    assertThat(request.getDeliveryStatus()).isTrue();
    peer.assertClosedByClient();
    assertNextCallHasItsOwnConnection();
  }

  /** Nothing of it can be taken for the next response. */
  @Test
  void whoClosesAResponseThatIsReceivedMayKeepItsConnection() throws Exception {
    Call call = begin();
    OutboundRequest request = call.request();
    Peer peer = call.peer();
    peer.send(Block.Kind.END, 4, (byte) 1, (byte) 2, (byte) 3, (byte) 4);
    InputStream in = request.getResponseInputStream();
    assertThat(in.read()).isEqualTo(1);
    in.close();
    OutboundRequest next = send();
    peer.awaitRequest();
    peer.send(Block.Kind.END, 1, (byte) 7);
    assertThat(next.getResponseInputStream().readAllBytes()).containsExactly(7);
  }

  /** A server of another mind; what follows would be read as the response of the next call. */
  @Test
  void whatFollowsAResponseEndsItsConnection() throws Exception {
    Call call = begin();
    OutboundRequest request = call.request();
    Peer peer = call.peer();
    peer.out.write(new byte[] {1, 0, 0, 1, 5, 1, 0, 0, 1, 66}); // two responses
    assertThat(request.getResponseInputStream().readAllBytes()).containsExactly(5);
    peer.assertClosedByClient();
    assertNextCallHasItsOwnConnection();
  }

  @Test
  void aServerThatEndsInTheMiddleOfABlockOrBetweenTwoIsReportedAtOnce() throws Exception {
    for (int announced : new int[] {2, 100}) {
      Call call = begin();
      OutboundRequest request = call.request();
      Peer peer = call.peer();
      peer.send(Block.Kind.PART, announced, (byte) 1, (byte) 2);
      peer.socket.close();
      InputStream in = request.getResponseInputStream();
      assertThat(in.readNBytes(2)).containsExactly(1, 2);
      assertThatThrownBy(in::read)
          .as("a block of " + announced + " bytes")
          .isInstanceOf(EOFException.class);
      in.close();
      assertThat(request.getDeliveryStatus()).isTrue();
      assertNextCallHasItsOwnConnection();
      endpoint.closeIdleConnections();
    }
  }

  @Test
  void aCallIsAbandonedInTheMiddleOfItsResponse() throws Exception {
    Call call = begin();
    OutboundRequest request = call.request();
    Peer peer = call.peer();
    peer.send(Block.Kind.PART, 100, (byte) 1);
    InputStream in = request.getResponseInputStream();
    assertThat(in.read()).isEqualTo(1);
    Future<?> reading =
        callers.submit(() -> assertThatThrownBy(in::read).isInstanceOf(IOException.class));
    request.abort();
    reading.get(30, TimeUnit.SECONDS);
    assertThat(request.getDeliveryStatus()).isTrue();
    peer.assertClosedByClient();
    in.close();
    assertNextCallHasItsOwnConnection();
  }

  /** Half a response is one that the server has begun: it must not say that nothing was run. */
  @Test
  void aServerThatAnnouncesTheEndInTheMiddleOfAResponseHasNotRefusedTheCall() throws Exception {
    Call call = begin();
    OutboundRequest request = call.request();
    Peer peer = call.peer();
    peer.send(Block.Kind.PART, 1, (byte) 1);
    peer.send(Block.Kind.CLOSING, 0);
    InputStream in = request.getResponseInputStream();
    assertThat(in.read()).isEqualTo(1);
    assertThatThrownBy(in::read)
        .isInstanceOf(IOException.class)
        .hasMessage("the peer interrupted a message by CLOSING");
    assertThat(request.getDeliveryStatus()).as("it may have run").isTrue();
    in.close();
    peer.assertClosedByClient();
  }
}
