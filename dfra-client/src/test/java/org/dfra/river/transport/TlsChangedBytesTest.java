package org.dfra.river.transport;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.jeri.InboundRequest;
import net.jini.jeri.OutboundRequest;
import net.jini.jeri.ServerEndpoint.ListenHandle;
import org.dfra.river.fixture.TestTeam;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.transport.FlippingRelay.Flip;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * One changed bit of a connection, in its handshake or its records, in either direction: no call is
 * executed and no answer believed.
 *
 * <p>{@code dfra.full}: a thousand connections; {@code dfra.soak}: a hundred thousand.
 */
class TlsChangedBytesTest {

  private static final int CONNECTIONS =
      Integer.getInteger(
          "dfra.transport.changes",
          Boolean.getBoolean("dfra.soak") ? 100_000 : Boolean.getBoolean("dfra.full") ? 1000 : 80);

  /** What changed connections may leave in the heap, in bytes. */
  private static final long HEAP = 8 << 20;

  /** An unfinished handshake is given up after 2 s. */
  private static final Duration PATIENCE = Duration.ofSeconds(30);

  /** A first connection has about so many bytes in either direction, a resumed one less. */
  private static final int CLIENT_BYTES = 1200;

  private static final int SERVER_BYTES = 1500;

  private static final long SEED = Long.getLong("dfra.transport.seed", 1811);

  private final TestIdentities team = new TestIdentities(new TestTeam("field"));
  private final ChannelIdentity robot = team.of(MemberRole.ROBOT, "atrv1");
  private final Random random = new Random(SEED);
  private final Set<Integer> executed = ConcurrentHashMap.newKeySet();
  private int refused;
  private int inVersion;
  private int untouched;

  @Test
  @Timeout(value = 3, unit = TimeUnit.HOURS)
  void noChangedBitIsAccepted() throws IOException {
    List<ListenHandle> handles = new ArrayList<>();
    TransportEndpoint listening =
        (TransportEndpoint)
            RecordingServer.endpoint(robot)
                .enumerateListenEndpoints(
                    each -> {
                      ListenHandle handle = each.listen(this::echo);
                      handles.add(handle);
                      return handle.getCookie();
                    });
    try (FlippingRelay relay = new FlippingRelay(listening.port())) {
      ChannelIdentity client = team.of(MemberRole.OPERATOR, "anna");
      call(to(relay.port(), client), -1);
      long heap = 0;
      int warmUp = Math.min(CONNECTIONS / 2, 500);
      long began = System.nanoTime();
      for (int i = 0; i < CONNECTIONS; i++) {
        if (i == warmUp) {
          heap = heapInUse();
        }
        if (i % 4 == 0 && i < 20_000) { // the others resume its session
          client = team.of(MemberRole.OPERATOR, "anna");
        }
        callChanged(i, relay, client);
        if (i % 100 == 0) {
          call(to(listening.port(), client), -1);
        }
      }
      System.out.printf(
          Locale.ROOT,
          "%d changed connections in %.1f s: %d refused, %d changed where TLS 1.3 looks at nothing,"
              + " %d were shorter; heap %d B before, %d B after%n",
          CONNECTIONS,
          (System.nanoTime() - began) / 1e9,
          refused,
          inVersion,
          untouched,
          heap,
          heapInUse());
      call(to(listening.port(), client), -1);
      long most = heap + HEAP;
      await("what unfinished handshakes occupy is given back")
          .atMost(PATIENCE)
          .until(() -> heapInUse() < most);
      assertThat(refused).as("refused").isGreaterThan(CONNECTIONS / 3);
      assertThat(
              Thread.getAllStackTraces().keySet().stream()
                  .filter(each -> each.getName().equals("dfra-connections"))
                  .count())
          .as("threads that have connections")
          .isOne();
    } finally {
      handles.forEach(ListenHandle::close);
    }
  }

  private void echo(InboundRequest request) {
    try (DataInputStream in = new DataInputStream(request.getRequestInputStream());
        DataOutputStream out = new DataOutputStream(request.getResponseOutputStream())) {
      int number = in.readInt();
      executed.add(number);
      out.writeInt(number);
    } catch (IOException e) {
      request.abort();
    }
  }

  private static void call(TransportEndpoint to, int number) throws IOException {
    OutboundRequest request = to.newRequest(InvocationConstraints.EMPTY).next();
    try (DataOutputStream out = new DataOutputStream(request.getRequestOutputStream())) {
      out.writeInt(number);
    }
    try (DataInputStream in = new DataInputStream(request.getResponseInputStream())) {
      assertThat(in.readInt()).as("the answer").isEqualTo(number);
    }
  }

  private static TransportEndpoint to(int port, ChannelIdentity client) {
    return CurrentIdentity.callAs(client, () -> new TransportEndpoint(RecordingServer.HOST, port));
  }

  private void callChanged(int number, FlippingRelay relay, ChannelIdentity client) {
    boolean isOfClient = random.nextBoolean();
    Flip flip =
        new Flip(
            isOfClient,
            random.nextInt(isOfClient ? CLIENT_BYTES : SERVER_BYTES),
            random.nextInt(8));
    relay.set(flip);
    TransportEndpoint endpoint = to(relay.port(), client);
    boolean isAnswered = false;
    try {
      call(endpoint, number);
      isAnswered = true;
    } catch (IOException e) {
      assertThat(e.getMessage()).as("%s", flip).isNotEmpty();
    }
    endpoint.closeIdleConnections();
    if (!relay.isFlipped()) {
      untouched++;
    } else if (relay.isInVersion()) {
      inVersion++;
    } else {
      refused++;
      assertThat(isAnswered).as("answered: %s, seed %d", flip, SEED).isFalse();
      if (isOfClient) {
        assertThat(executed).as("executed: %s, seed %d", flip, SEED).doesNotContain(number);
      }
    }
  }

  /** What a full collection leaves, in bytes. */
  private static long heapInUse() {
    System.gc();
    return ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed();
  }
}
