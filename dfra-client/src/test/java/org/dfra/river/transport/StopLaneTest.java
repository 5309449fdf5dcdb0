package org.dfra.river.transport;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.BasicObjectEndpoint;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.module.StopsRobot;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.fixture.TestTeam;
import org.dfra.river.identity.AnonymousIdentity;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.transport.ConnectionLimits.Resource;
import org.dfra.security.Decision;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Members and strangers use everything that a server has: threads of calls, halves of requests,
 * connections, and handshakes without an end. A member's stop is not delayed.
 */
@Timeout(120)
class StopLaneTest {

  /** The operator's own address is flooded, too. */
  private static final String[] FLOODED = {RecordingServer.HOST, "127.0.0.66", "127.0.0.67"};

  private static final Duration DEADLINE = Duration.ofSeconds(60);
  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final Duration PROMPT = Duration.ofMillis(500);
  private static final int STOPS = 20;

  /** What the flood and the operator call. */
  interface Robot extends Remote {

    /** Ends when the test does. */
    int hold() throws RemoteException;

    /** Returns at once. */
    int look() throws RemoteException;

    @StopsRobot
    int stop(String by) throws RemoteException;
  }

  private static final class RobotImpl implements Robot {

    final CountDownLatch released = new CountDownLatch(1);
    final AtomicInteger stops = new AtomicInteger();

    @Override
    public int hold() {
      try {
        released.await();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      return 0;
    }

    @Override
    public int look() {
      return stops.get();
    }

    @Override
    public int stop(String by) {
      return stops.incrementAndGet();
    }
  }

  private final TestIdentities team = new TestIdentities(new TestTeam("field"));
  private final ChannelIdentity robot =
      team.guarded(MemberRole.ROBOT, "atrv1", request -> Decision.permit("test"));
  private final ChannelIdentity anna = team.of(MemberRole.OPERATOR, "anna");
  private final ChannelIdentity otto = team.of(MemberRole.OBSERVER, "otto");
  private final Uuid id = UuidFactory.generate();
  private final RobotImpl impl = new RobotImpl();
  private final ExecutorService threads = Executors.newCachedThreadPool();
  private final AtomicBoolean isOver = new AtomicBoolean();
  private final AtomicInteger handshakes = new AtomicInteger();
  private final List<RawTls> clients = new ArrayList<>();
  private BasicJeriExporter exporter;
  private int port;

  @BeforeEach
  void export() throws Exception {
    exporter =
        new BasicJeriExporter(
            RecordingServer.endpoint(robot), new DeadlineILFactory(), false, true, id);
    Remote proxy = exporter.export(impl);
    port = Objects.requireNonNull(PeerAddress.of(proxy)).port();
  }

  @AfterEach
  void end() throws Exception {
    isOver.set(true);
    impl.released.countDown();
    for (RawTls each : clients) {
      each.close();
    }
    threads.shutdown();
    boolean unused = threads.awaitTermination(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    exporter.unexport(true);
    await().atMost(PATIENCE).until(() -> total(Resource.CONNECTIONS) == 0);
  }

  private Robot from(ChannelIdentity client, String source, Duration deadline) {
    return CurrentIdentity.callAs(
        client,
        () ->
            (Robot)
                DeadlineILFactory.proxy(
                    new BasicObjectEndpoint(
                        new SourceBoundEndpoint(RecordingServer.HOST, port, source, 0), id, false),
                    deadline,
                    Robot.class.getClassLoader(),
                    Robot.class));
  }

  private static int total(Resource resource) {
    return ConnectionSelector.instance().limits().total(resource);
  }

  /** All threads of calls that others may have: of the operator's address, and in total. */
  private void takeAllWorkers() {
    for (String source : FLOODED) {
      Robot ottos = from(otto, source, DEADLINE);
      for (int i = 0; i < 128; i++) {
        threads.execute(
            () -> {
              while (!isOver.get()) {
                try {
                  CurrentIdentity.callAs(otto, ottos::hold);
                } catch (RemoteException e) {
                  // its connection was not made in time; again
                }
              }
            });
      }
    }
    await().atMost(PATIENCE).until(() -> total(Resource.WORKERS) >= 384);
  }

  /** Halves of requests, as many as are kept, of a member and of a stranger. */
  private void sendHalves() throws IOException {
    for (String source : FLOODED) {
      for (int i = 0; i < 60; i++) {
        RawTls half =
            RawTls.connected(source, port, i % 2 == 0 ? otto : AnonymousIdentity.instance());
        clients.add(half);
        half.send(Arrays.copyOf(half.block(Block.Kind.END, new byte[100]), 6));
      }
    }
  }

  /** Connections without an end, beyond the limit of each address, each with a handshake. */
  private void flood(String source) {
    List<RawTls> open = new ArrayList<>();
    while (!isOver.get()) {
      try {
        RawTls each = RawTls.greeted(source, port, AnonymousIdentity.instance());
        open.add(each);
        each.send(each.hello());
        handshakes.incrementAndGet();
        if (open.size() > 300) {
          open.remove(0).close();
        }
      } catch (IOException e) {
        // refused: there are too many
      }
    }
    open.forEach(StopLaneTest::close);
  }

  private static void close(RawTls client) {
    try {
      client.close();
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void aStopIsPromptWhileAllLimitsAreReached() throws Exception {
    takeAllWorkers();
    sendHalves();
    for (String source : FLOODED) {
      for (int i = 0; i < 2; i++) {
        threads.execute(() -> flood(source));
      }
    }
    await().atMost(PATIENCE).until(() -> handshakes.get() > 500);
    Robot annas = from(anna, RecordingServer.HOST, Duration.ofSeconds(10));
    assertThatThrownBy(() -> CurrentIdentity.callAs(anna, annas::look))
        .as("another call, since all threads are in use")
        .isInstanceOf(RemoteException.class);
    SourceBoundEndpoint endpoint =
        new SourceBoundEndpoint(RecordingServer.HOST, port, RecordingServer.HOST, 0);
    List<Timing> stops = new ArrayList<>();
    try (StallProbe probe = StallProbe.start()) {
      for (int i = 0; i < STOPS; i++) {
        CurrentIdentity.callAs(
            anna,
            () -> {
              endpoint.closeIdleConnections();
              return true;
            });
        StallProbe.Stopwatch watch = probe.stopwatch();
        CurrentIdentity.callAs(anna, () -> annas.stop("anna"));
        stops.add(watch.stop());
      }
    }
    assertThat(impl.stops).hasValue(STOPS);
    System.out.printf(
        Locale.ROOT,
        "%d stops on new connections beside %d handshakes and %d calls: the slowest %s%n",
        STOPS,
        handshakes.get(),
        total(Resource.WORKERS),
        stops.stream().max(Comparator.comparing(Timing::took)).orElseThrow());
    for (Timing each : stops) {
      each.requireWithin("a stop while all limits are reached", PROMPT);
    }
  }

  @Test
  void whoMakesManyStopsTakesNoMoreThanAFew() {
    StopLane lane = new StopLane();
    StopLane.Share stranger = new StopLane.Share("192.0.2.66", false);
    for (int i = 0; i < StopLane.CALLS_OF_CALLER; i++) {
      assertThat(lane.take(stranger)).isTrue();
    }
    assertThat(lane.take(stranger)).isFalse();
    int taken = StopLane.CALLS_OF_CALLER;
    for (int i = 0; i < 1000; i++) {
      taken += lane.take(new StopLane.Share("192.0.2." + i, false)) ? 1 : 0;
    }
    assertThat(taken).isEqualTo(StopLane.CALLS_OF_STRANGERS);
    StopLane.Share member = new StopLane.Share("anna", true);
    assertThat(lane.take(member)).as("a member, beside all strangers").isTrue();
    lane.giveBack(stranger);
    assertThat(lane.take(stranger)).isTrue();
  }
}
