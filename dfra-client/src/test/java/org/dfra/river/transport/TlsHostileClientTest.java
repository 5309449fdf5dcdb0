package org.dfra.river.transport;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.dfra.river.transport.RecordingServer.call;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.river.fixture.TestTeam;
import org.dfra.river.identity.AnonymousIdentity;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.transport.ConnectionLimits.Resource;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Whatever a client does below or with TLS, most of them without any certificate: the server uses
 * bounded threads and memory for it, and serves all others.
 */
@Timeout(120)
class TlsHostileClientTest {

  private static final String ATTACKER = "127.0.0.66";
  private static final String ANOTHER = "127.0.0.77";
  private static final Duration PATIENCE = Duration.ofSeconds(10);

  /** A connection is closed 2 s after its last byte; connections are checked twice a second. */
  private static final long GIVEN_UP_MILLIS = 3500;

  private static final int IDLE = 500;

  private final TestIdentities team = new TestIdentities(new TestTeam("field"));
  private final ChannelIdentity robot = team.of(MemberRole.ROBOT, "atrv1");
  private final ChannelIdentity anna = team.of(MemberRole.OPERATOR, "anna");
  private final RecordingServer server = RecordingServer.as(robot);
  private final List<RawTls> clients = new ArrayList<>();
  private final ExecutorService threads = Executors.newCachedThreadPool();

  @AfterEach
  void close() throws IOException {
    threads.shutdownNow();
    for (RawTls each : clients) {
      each.close();
    }
    server.close();
  }

  private RawTls greeted() throws IOException {
    RawTls client = RawTls.greeted(ATTACKER, server.port(), AnonymousIdentity.instance());
    clients.add(client);
    return client;
  }

  private RawTls connected() throws IOException {
    RawTls client = RawTls.connected(ATTACKER, server.port(), AnonymousIdentity.instance());
    clients.add(client);
    return client;
  }

  /** On new connections, too. */
  private void assertServes() throws Exception {
    TransportEndpoint annas = server.from(anna);
    for (int i = 0; i < 2; i++) {
      Future<byte[]> answer = threads.submit(() -> call(annas));
      assertThat(answer.get(10, TimeUnit.SECONDS)).as("an honest call").containsExactly(1, 2, 3);
      annas.closeIdleConnections();
    }
  }

  private static long threads(String prefix) {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(each -> each.getName().startsWith(prefix))
        .count();
  }

  private static int total(Resource resource) {
    return ConnectionSelector.instance().limits().total(resource);
  }

  @Test
  void halfARecordStopsNobodyAndIsGivenUp() throws Exception {
    RawTls half = connected();
    byte[] record = half.block(Block.Kind.END, new byte[100]);
    half.send(Arrays.copyOf(record, record.length / 2));
    assertServes();
    long began = System.nanoTime();
    byte[] unused = half.readRawToEnd();
    assertThat(millisSince(began)).as("ms until it is closed").isLessThan(GIVEN_UP_MILLIS);
    assertServes();
  }

  @Test
  void halfARecordBehindAHandshakeIsGivenUp() throws Exception {
    RawTls half =
        RawTls.connectedWithHalfARecord(ATTACKER, server.port(), AnonymousIdentity.instance());
    clients.add(half);
    long began = System.nanoTime();
    byte[] unused = half.readRawToEnd();
    assertThat(millisSince(began)).as("ms until it is closed").isLessThan(GIVEN_UP_MILLIS);
    assertServes();
  }

  private static long millisSince(long began) {
    return TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - began);
  }

  @Test
  void theRestOfARecordMayComeLater() throws Exception {
    RawTls slow = connected();
    byte[] record = slow.block(Block.Kind.END, new byte[] {4, 5});
    long before = TransportTraffic.now().bytesReceived();
    for (int at = 0; at < record.length; at++) {
      slow.send(new byte[] {record[at]});
      if (at % 8 == 0) {
        long sent = before + at + 1; // it arrives in many parts
        await().atMost(PATIENCE).until(() -> TransportTraffic.now().bytesReceived() >= sent);
      }
    }
    assertThat(slow.readData(6)).containsExactly(1, 0, 0, 2, 4, 5);
  }

  @Test
  void halfRecordsOfAnAddressHaveALimit() throws Exception {
    int limit = 1 << 20; // of PARTIAL_BYTES for an address
    for (int i = 0; i < 120; i++) {
      RawTls half = connected();
      half.send(Arrays.copyOf(half.block(Block.Kind.END, new byte[100]), 6));
    }
    assertThat(total(Resource.PARTIAL_BYTES)).as("bytes").isLessThanOrEqualTo(limit);
    assertServes();
    await().atMost(PATIENCE).until(() -> total(Resource.PARTIAL_BYTES) == 0);
  }

  @Test
  void aFloodOfPausesLeavesTheOthersTheirTurns() throws Exception {
    AtomicBoolean isOver = new AtomicBoolean();
    List<Future<?>> floods = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      RawTls flood = connected();
      floods.add(threads.submit(() -> sendUntil(isOver, flood)));
    }
    for (int i = 0; i < 5; i++) {
      assertServes();
    }
    isOver.set(true);
    for (Future<?> each : floods) {
      each.get(10, TimeUnit.SECONDS);
    }
  }

  private static Object sendUntil(AtomicBoolean isOver, RawTls flood) throws IOException {
    while (!isOver.get()) {
      flood.send(flood.block(Block.Kind.PAUSE, new byte[0]));
    }
    return flood;
  }

  @Test
  void aFloodOfNewKeysEndsTheConnection() throws Exception {
    RawTls flood = connected();
    int sent = 0;
    try {
      for (; sent < 10_000; sent++) {
        flood.send(flood.keyUpdate());
      }
    } catch (IOException e) {
      // the server has ended it
    }
    assertThat(sent).as("requests for new keys until the connection was ended").isLessThan(10_000);
    assertServes();
  }

  @Test
  void aFewNewKeysAreFine() throws Exception {
    RawTls client = connected();
    for (int i = 0; i < 5; i++) {
      client.send(client.keyUpdate());
      client.send(client.block(Block.Kind.END, new byte[] {7}));
      assertThat(client.readData(5)).containsExactly(1, 0, 0, 1, 7);
    }
  }

  @Test
  void handshakesThatAreNeverFinishedHoldNoThreadAndAreClosed() throws Exception {
    assertServes();
    long workers = threads("dfra-worker-");
    long began = System.nanoTime();
    for (int i = 0; i < 100; i++) {
      RawTls half = greeted();
      byte[] hello = half.hello();
      half.send(i % 2 == 0 ? hello : Arrays.copyOf(hello, hello.length / 2));
    }
    assertServes();
    assertThat(threads("dfra-handshake-")).as("threads").isLessThanOrEqualTo(2);
    assertThat(threads("dfra-worker-")).as("workers").isLessThanOrEqualTo(workers + 1);
    for (RawTls each : clients) {
      byte[] unused = each.readRawToEnd();
    }
    assertThat(millisSince(began)).as("ms until all are closed").isLessThan(2 * GIVEN_UP_MILLIS);
  }

  @Test
  void aLongHandshakeIsRefused() throws Exception {
    RawTls client = greeted();
    byte[] record = new byte[5 + 4096];
    record[0] = 22; // handshake
    record[1] = 3;
    record[2] = 3;
    record[3] = 16;
    record[5] = 1; // a ClientHello of 16 MiB
    record[6] = (byte) 0xff;
    long began = System.nanoTime();
    try {
      for (int i = 0; i < 100; i++) {
        client.send(record);
        record[5] = 0;
        record[6] = 0;
      }
    } catch (IOException e) {
      // refused already
    }
    byte[] unused = client.readRawToEnd();
    assertThat(millisSince(began)).as("ms until it is closed").isLessThan(GIVEN_UP_MILLIS);
    assertServes();
  }

  @Test
  void nothingIsPlainAfterTlsWasAgreed() throws Exception {
    RawTls plain = greeted();
    plain.send(new byte[] {1, 0, 0, 3, 1, 2, 3});
    byte[] answer = plain.readRawToEnd();
    if (answer.length > 0) {
      assertThat(answer[0]).as("an alert of TLS").isEqualTo((byte) 21);
    }
    RawTls later = connected();
    later.send(new byte[] {1, 0, 0, 3, 1, 2, 3, 0, 0, 0, 0, 0, 0});
    byte[] rest = later.readRawToEnd();
    assertThat(new String(rest, StandardCharsets.ISO_8859_1))
        .as("an answer")
        .doesNotContain("\1\2\3");
    assertThat(server.dispatched()).isZero();
    assertServes();
  }

  @Test
  void seventeenClientsConnectBesideAFloodOfHandshakes() throws Exception {
    assertServes();
    AtomicBoolean isOver = new AtomicBoolean();
    AtomicInteger hellos = new AtomicInteger();
    for (String source : List.of(ATTACKER, "127.0.0.67")) {
      for (int i = 0; i < 4; i++) {
        Future<?> unused = threads.submit(() -> floodUntil(isOver, source, hellos));
      }
    }
    await().atMost(PATIENCE).until(() -> hellos.get() > 100);
    InetAddress source = InetAddress.getByName(ANOTHER);
    TransportEndpoint annas = server.from(anna);
    List<Callable<Long>> calls = new ArrayList<>();
    for (int i = 0; i < 17; i++) {
      ClientConnections one = ClientConnections.to(annas, source, i);
      calls.add(
          () -> {
            long began = System.nanoTime();
            ClientConnection connection = one.open();
            long took = millisSince(began);
            connection.close();
            return took;
          });
    }
    long longest = 0;
    for (Future<Long> each : threads.invokeAll(calls)) {
      longest = Math.max(longest, each.get());
    }
    isOver.set(true);
    System.out.printf(
        Locale.ROOT,
        "17 clients beside %d handshakes of a flood: the last was connected after %d ms%n",
        hellos.get(),
        longest);
    assertThat(longest).as("ms until the last is connected").isLessThan(5000);
  }

  private Object floodUntil(AtomicBoolean isOver, String source, AtomicInteger hellos)
      throws IOException {
    while (!isOver.get()) {
      try (RawTls each = RawTls.greeted(source, server.port(), AnonymousIdentity.instance())) {
        each.send(each.hello());
        hellos.incrementAndGet();
        int unused = each.socket().getInputStream().read();
      } catch (IOException e) {
        // refused: there are too many
      }
    }
    return hellos;
  }

  @Test
  void idleConnectionsNeedLittleMemory() throws Exception {
    for (int i = 0; i < 50; i++) {
      callOnce(connected());
    }
    long before = heapInUse();
    List<RawTls> idle = new ArrayList<>();
    for (int i = 0; i < IDLE - 50; i++) {
      RawTls each = connected();
      idle.add(each);
      callOnce(each);
    }
    await().atMost(PATIENCE).until(() -> total(Resource.PARTIAL_BYTES) == 0);
    await().atMost(PATIENCE).until(() -> total(Resource.WORKERS) == 0); // the selector has them
    long after = heapInUse();
    for (RawTls one : idle) {
      one.close();
    }
    long each = (after - before) / idle.size() - RawTls.BUFFER;
    System.out.printf(
        Locale.ROOT,
        "%d idle connections: %d B of heap for each, of client and server%n",
        idle.size(),
        each);
    assertThat(each).as("bytes for each").isLessThan(32 * 1024);
  }

  private static void callOnce(RawTls client) throws IOException {
    client.send(client.block(Block.Kind.END, new byte[] {7}));
    assertThat(client.readData(5)).containsExactly(1, 0, 0, 1, 7);
    client.send(client.block(Block.Kind.PAUSE, new byte[0]));
  }

  private static long heapInUse() {
    System.gc();
    return ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed();
  }
}
