package org.dfra.river.transport;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.lang.management.ManagementFactory;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.jeri.InboundRequest;
import net.jini.jeri.OutboundRequest;
import net.jini.jeri.ServerEndpoint.ListenHandle;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Whatever a client sends or fails to send: the server uses bounded threads and memory for it, and
 * serves all others.
 *
 * <p>{@code dfra.soak}: a million changed conversations instead of 10 000.
 */
@Timeout(120)
class HostileClientTest {

  private static final String HOST = "127.0.0.1";
  private static final String ATTACKER = "127.0.0.66";
  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final int MUTATIONS =
      Integer.getInteger(
          "dfra.transport.mutations", Boolean.getBoolean("dfra.soak") ? 1_000_000 : 10_000);

  /** So many come before memory is measured: classes are loaded, pools filled. */
  private static final int WARM_UP = 1000;

  /** What changed conversations may leave in the heap, in bytes. */
  private static final long HEAP = 8 << 20;

  private final List<Socket> sockets = new ArrayList<>();
  private ListenHandle handle;
  private TransportEndpoint endpoint;

  @BeforeEach
  void listen() throws IOException {
    endpoint =
        (TransportEndpoint)
            new TransportServerEndpoint(HOST, 0)
                .enumerateListenEndpoints(
                    each -> {
                      handle = each.listen(HostileClientTest::echo);
                      return handle.getCookie();
                    });
  }

  @AfterEach
  void close() throws IOException {
    for (Socket each : sockets) {
      each.close();
    }
    handle.close();
  }

  private static void echo(InboundRequest request) {
    try (InputStream in = request.getRequestInputStream();
        OutputStream out = request.getResponseOutputStream()) {
      out.write(in.readAllBytes());
    } catch (IOException e) {
      request.abort();
    }
  }

  private byte[] call(byte[] bytes) throws IOException {
    OutboundRequest request = endpoint.newRequest(InvocationConstraints.EMPTY).next();
    try (OutputStream out = request.getRequestOutputStream()) {
      out.write(bytes);
    }
    try (InputStream in = request.getResponseInputStream()) {
      return in.readAllBytes();
    }
  }

  private void assertServes() throws IOException {
    assertThat(call(new byte[] {1, 2, 3})).containsExactly(1, 2, 3);
  }

  private Socket connect() throws IOException {
    return connectFrom(ATTACKER);
  }

  private Socket connectFrom(String source) throws IOException {
    Socket socket = new Socket();
    sockets.add(socket);
    socket.bind(new InetSocketAddress(InetAddress.getByName(source), 0));
    socket.connect(new InetSocketAddress(HOST, endpoint.port()));
    socket.setSoTimeout(30_000);
    socket.setTcpNoDelay(true);
    return socket;
  }

  private Socket greeted() throws IOException {
    return greeted(connect());
  }

  private static Socket greeted(Socket socket) throws IOException {
    socket.getOutputStream().write(greeting());
    assertThat(socket.getInputStream().readNBytes(Greeting.SERVER_BYTES))
        .hasSize(Greeting.SERVER_BYTES);
    return socket;
  }

  private static byte[] greeting() {
    ByteBuffer bytes = ByteBuffer.allocate(Greeting.CLIENT_BYTES);
    Greeting.putClient(bytes, Greeting.ANY_SERVER, false, false);
    return bytes.array();
  }

  private static void send(Socket to, Block.Kind kind, int length, byte[] bytes)
      throws IOException {
    DataOutputStream out = new DataOutputStream(to.getOutputStream());
    out.writeInt(Block.encode(kind, length));
    out.write(bytes);
  }

  private static long threads() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(each -> each.getName().startsWith("dfra-worker-"))
        .count();
  }

  /** Waits until the server has closed it, and returns what it sent. */
  private static byte[] readToEnd(Socket socket) throws IOException {
    try {
      return socket.getInputStream().readAllBytes();
    } catch (SocketTimeoutException e) {
      throw new AssertionError("the connection stays open", e);
    } catch (SocketException e) { // reset
      return new byte[0];
    }
  }

  @Test
  void halfABlockOccupiesNoThreadAndIsGivenUp() throws IOException {
    assertServes();
    long before = threads();
    List<Socket> half = new ArrayList<>();
    for (int i = 0; i < 100; i++) {
      Socket socket = greeted();
      send(socket, Block.Kind.END, 100, new byte[50]);
      half.add(socket);
    }
    assertServes();
    assertThat(threads()).as("threads").isLessThanOrEqualTo(before + 1);
    for (Socket each : half) {
      assertThat(readToEnd(each)).isEmpty();
    }
    assertServes();
  }

  @Test
  void threeThousandUnfinishedRequestsLeaveThreadsAndTheServer() throws IOException {
    assertServes();
    long before = threads();
    int refused = 0;
    for (int i = 0; i < 3000; i++) {
      try {
        send(greeted(), Block.Kind.PART, 10, new byte[10]);
      } catch (IOException e) { // the attacker has too many
        refused++;
      }
      if (i % 500 == 0) {
        assertServes();
        assertThat(threads()).as("threads").isLessThanOrEqualTo(before + 64);
      }
    }
    assertServes();
    assertThat(threads()).as("threads").isLessThanOrEqualTo(before + 64);
    assertThat(refused).as("refused connections").isLessThan(3000);
  }

  @Test
  void twoThousandIdleConnectionsLeaveTheServerServing() throws IOException {
    for (int i = 0; i < 2000; i++) {
      Socket unused = connect();
    }
    assertServes();
    Socket late = greeted();
    send(late, Block.Kind.END, 2, new byte[] {8, 9});
    assertThat(late.getInputStream().readNBytes(6))
        .as("the attacker's own newest connection")
        .containsExactly(1, 0, 0, 2, 8, 9);
  }

  @Test
  void manyConnectionsFromEachOfSeveralAddressesLeaveAPlaceForAnother() throws IOException {
    int each = 520; // more than one address may have; all together more than all may
    for (String source : new String[] {"127.0.0.61", "127.0.0.62", "127.0.0.63", "127.0.0.64"}) {
      for (int i = 0; i < each; i++) {
        Socket unused = greeted(connectFrom(source));
      }
    }
    endpoint.closeIdleConnections();
    assertServes();
    Socket late = greeted();
    send(late, Block.Kind.END, 1, new byte[] {4});
    assertThat(late.getInputStream().readNBytes(5)).containsExactly(1, 0, 0, 1, 4);
  }

  @Test
  void pausesDoNotHideAnUnfinishedRequest() throws IOException {
    assertServes();
    long before = threads();
    ByteBuffer conversation = ByteBuffer.allocate(32);
    conversation.putInt(Block.encode(Block.Kind.END, 1)).put((byte) 9);
    conversation.putInt(Block.encode(Block.Kind.PAUSE, 0));
    conversation.putInt(Block.encode(Block.Kind.PAUSE, 0));
    conversation.putInt(Block.encode(Block.Kind.PART, 4)).putInt(1);
    byte[] bytes = new byte[conversation.position()];
    conversation.flip().get(bytes);
    for (int i = 0; i < 100; i++) {
      Socket socket = greeted();
      socket.getOutputStream().write(bytes);
      assertThat(socket.getInputStream().readNBytes(5)).containsExactly(1, 0, 0, 1, 9);
    }
    assertServes();
    assertThat(threads()).as("threads").isLessThanOrEqualTo(before + 64);
    assertThat(ConnectionSelector.instance().limits().total(ConnectionLimits.Resource.WORKERS))
        .as("calls that occupy a thread")
        .isLessThanOrEqualTo(40);
  }

  @Test
  void aSenderOfSingleBytesIsGivenUpWhenItPauses() throws IOException {
    Socket slow = greeted();
    OutputStream out = slow.getOutputStream();
    for (byte each : new byte[] {1, 0, 0, 3, 5}) { // a block of three bytes, of which one arrives
      out.write(each);
    }
    assertThat(readToEnd(slow)).isEmpty();
    assertServes();
  }

  @Test
  void aClientThatNeverGreetsIsGivenUp() throws IOException {
    assertThat(readToEnd(connect())).isEmpty();
  }

  @Test
  void aClientThatSpeaksAnotherProtocolIsRefusedAtOnce() throws IOException {
    Socket other = connect();
    other.getOutputStream().write("GET / HTTP/1.1\r\nHost: robot\r\n\r\n".getBytes("US-ASCII"));
    assertThat(readToEnd(other)).isEmpty();
  }

  @Test
  void aClientOfAnotherVersionLearnsIt() throws IOException {
    Socket other = connect();
    byte[] greeting = greeting();
    greeting[4] = 99;
    other.getOutputStream().write(greeting);
    assertThat(readToEnd(other))
        .containsExactly('D', 'F', 'R', 'A', 1, Greeting.Answer.OTHER_VERSION.ordinal(), 0, 0);
  }

  @Test
  void aClientThatTakesNoResponseEndsOnlyItsOwnConnection() throws IOException {
    Socket greedy = greeted();
    greedy.setSoTimeout(100);
    byte[] block = new byte[Block.MAX_BYTES];
    try {
      for (int i = 0; i < 2000; i++) { // 32 MB that come back, and are not read
        send(greedy, Block.Kind.PART, block.length, block);
      }
      send(greedy, Block.Kind.END, 0, new byte[0]);
    } catch (SocketException e) {
      // the server has given it up already
    }
    assertServes();
    await("the connection ends").atMost(PATIENCE).until(() -> isClosedByServer(greedy));
  }

  /** JERI's object for garbage collection, which the dispatcher must not see. */
  @ParameterizedTest
  @ValueSource(ints = {1, 5, 15, 16, 17, 24})
  void callsOfTheGarbageCollectorAreNotDispatchedHoweverTheyAreSplit(int size) throws IOException {
    ByteBuffer call = ByteBuffer.allocate(24);
    call.putLong(0xd32c_d1bc_273c_11b2L).putLong(0x8841_0800_20c9_e4a1L).putLong(7);
    Socket socket = greeted();
    sendSplit(socket, call.array(), size);
    assertThat(socket.getInputStream().readNBytes(5))
        .as("no such object")
        .containsExactly(1, 0, 0, 1, 0);
    byte[] other = call.array().clone();
    other[15]++;
    sendSplit(socket, other, size);
    assertThat(socket.getInputStream().readNBytes(4))
        .as("another object")
        .containsExactly(1, 0, 0, 24);
    assertThat(socket.getInputStream().readNBytes(24)).isEqualTo(other);
  }

  private static void sendSplit(Socket to, byte[] message, int size) throws IOException {
    for (int at = 0; at < message.length; at += size) {
      byte[] part = Arrays.copyOfRange(message, at, Math.min(message.length, at + size));
      boolean isLast = at + size >= message.length;
      send(to, isLast ? Block.Kind.END : Block.Kind.PART, part.length, part);
      if (!isLast) {
        send(to, Block.Kind.PART, 0, new byte[0]);
      }
    }
  }

  private static boolean isClosedByServer(Socket socket) {
    try {
      socket.getOutputStream().write(new byte[8]);
      return false;
    } catch (IOException e) {
      return true;
    }
  }

  /** Changed bytes of valid conversations, each on a connection of its own. */
  @Test
  @Timeout(value = 3, unit = TimeUnit.HOURS)
  void changedBytesEndOnlyTheirOwnConnection() throws IOException {
    Random random = new Random(4711);
    ByteBuffer valid = ByteBuffer.allocate(100);
    valid.put(greeting());
    valid.putInt(Block.encode(Block.Kind.END, 8)).putLong(42);
    valid.putInt(Block.encode(Block.Kind.PART, 4)).putInt(7);
    valid.putInt(Block.encode(Block.Kind.END, 0));
    valid.putInt(Block.encode(Block.Kind.PAUSE, 0));
    byte[] bytes = new byte[valid.position()];
    valid.flip().get(bytes);
    assertServes();
    long before = threads();
    sendChanged(bytes, WARM_UP, random);
    long heap = heapInUse();
    long began = System.nanoTime();
    sendChanged(bytes, MUTATIONS, random);
    System.out.printf(
        Locale.ROOT,
        "%d changed conversations in %.1f s; workers: %d before, %d after; heap: %d B before, %d B"
            + " after%n",
        MUTATIONS,
        (System.nanoTime() - began) / 1e9,
        before,
        threads(),
        heap,
        heapInUse());
    assertServes();
    assertThat(threads()).as("threads").isLessThanOrEqualTo(before + 64);
    await("connections are forgotten")
        .atMost(PATIENCE)
        .until(
            () ->
                ConnectionSelector.instance()
                        .limits()
                        .total(ConnectionLimits.Resource.PARTIAL_BYTES)
                    == 0);
    await("no memory is kept").atMost(PATIENCE).until(() -> heapInUse() <= heap + HEAP);
  }

  private void sendChanged(byte[] conversation, int count, Random random) throws IOException {
    for (int i = 0; i < count; i++) {
      byte[] changed = conversation.clone();
      for (int n = random.nextInt(3); n >= 0; n--) {
        changed[random.nextInt(changed.length)] = (byte) random.nextInt(256);
      }
      int length = random.nextInt(4) == 0 ? random.nextInt(changed.length) : changed.length;
      try (Socket socket = connect()) {
        socket.setSoLinger(true, 0); // leaves no port behind
        socket.getOutputStream().write(changed, 0, length);
      } catch (IOException e) {
        // the server has ended it while it was written to
      }
      sockets.clear();
      if (i % 1000 == 0) {
        assertServes();
      }
    }
  }

  /** What a full collection leaves, in bytes. */
  private static long heapInUse() {
    System.gc();
    return ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed();
  }
}
