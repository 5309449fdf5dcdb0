package org.dfra.hosts;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.awaitility.core.ConditionFactory;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.examples.harness.SimulationProcess;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.testing.NetworkNamespaceHosts;
import org.dfra.testing.SerialCable;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

/**
 * Two robots on two hosts search a region by raster; the radio between them is cut silently. Their
 * devices are in one simulated world, at the ends of serial cables, which nobody cuts. The second
 * robot's clock is 0.8 s ahead and gains a tenth of a millisecond in a second.
 */
@Timeout(1200)
@EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "takes minutes")
class TwoSearchersIT {

  private static final Path ROOT = Path.of(System.getProperty("dfra.root"));
  private static final Duration PATIENCE = Duration.ofSeconds(180);

  /** Longer than a lease of 30 s and the three seconds after which silence counts. */
  private static final Duration CUT = Duration.ofSeconds(60);

  /** What the second robot's clock gains, seconds in a second, and since how many seconds. */
  private static final double DRIFT = 1e-4;

  private static final long SINCE = 8000;

  /** What a robot reports of a gap. */
  private static final Pattern GAP =
      Pattern.compile("(atrv\\d) was out of reach for (\\d+) s, (\\d+) readings missed");

  @TempDir static Path folder;

  private static final Instant SKEWED_FROM =
      Instant.now().minusSeconds(SINCE).truncatedTo(ChronoUnit.SECONDS);
  private static final List<SerialCable> CABLES = new ArrayList<>();

  private static NetworkNamespaceHosts network;
  private static DemoEnvironment phase;
  private static Path sockets;
  private static List<RobotHost> hosts = List.of();

  @BeforeAll
  static void bringUpBothRobotsAndTheirWorld() throws Exception {
    Optional<String> refusal = NetworkNamespaceHosts.unavailableReason();
    assumeTrue(refusal.isEmpty(), () -> refusal.orElse(""));
    network = new NetworkNamespaceHosts();
    phase = new DemoEnvironment();
    sockets = Files.createTempDirectory("dfra-cables-"); // a socket's name must be short
    Path field = ROOT.resolve("config/worlds/raster.xml");
    SimulationProcess world = SimulationProcess.start(phase, field, List.of("--seed=3"));
    RobotHost first = host(world, 0, "real");
    hosts = List.of(first);
    String skewed = String.format(Locale.ROOT, "%.4fx since %s", 1 + DRIFT, SKEWED_FROM);
    hosts = List.of(first, host(world, 1, skewed));
    for (RobotHost host : hosts) {
      for (RobotHost other : hosts) {
        patiently()
            .untilAsserted(
                () ->
                    assertThat(host.ask("ready " + other.robot()))
                        .as("of %s seen from %s: %s", other.robot(), host.robot(), host.log())
                        .isEqualTo(Integer.toString(modules(other.robot()))));
      }
    }
  }

  private static RobotHost host(SimulationProcess world, int number, String time) throws Exception {
    String robot = "atrv" + (number + 1);
    List<String> client = new ArrayList<>(List.of(SearcherClient.class.getName()));
    for (Map.Entry<String, String> line : world.links(robot).entrySet()) {
      Path socket = sockets.resolve(robot + "-" + line.getKey());
      CABLES.add(SerialCable.deviceEnd(socket, line.getValue()));
      client.add(line.getKey().toUpperCase(Locale.ROOT) + "=" + socket);
    }
    Path xml = RobotHost.shipped("raster", robot);
    return new RobotHost(network, number, "raster", xml, folder.resolve(robot), time, client);
  }

  /** As many as its XML has. */
  private static int modules(String robot) throws Exception {
    String xml = Files.readString(RobotHost.shipped("raster", robot));
    return xml.split("<module ", -1).length - 1;
  }

  @AfterAll
  static void takeDown() throws Exception {
    try (NetworkNamespaceHosts removed = network;
        DemoEnvironment ended = phase) {
      for (RobotHost host : hosts) {
        host.close();
      }
      assertThat(removed == null).isEqualTo(ended == null);
    }
    for (SerialCable cable : CABLES) {
      cable.close();
    }
    if (sockets != null) {
      try (var files = Files.list(sockets)) {
        for (Path socket : files.toList()) {
          Files.delete(socket);
        }
      }
      Files.delete(sockets);
    }
  }

  /** A call that a busy machine did not answer in time is made again. */
  private static ConditionFactory patiently() {
    return await()
        .ignoreException(NumberFormatException.class)
        .atMost(PATIENCE)
        .pollInterval(Duration.ofMillis(200));
  }

  /** Ten lanes of 5.5 m beside the posts of the field: some minutes. */
  private static String region() {
    LocalFrame frame = new LocalFrame(new GeoPosition(48, 11, 520)); // the world's datum
    StringBuilder corners = new StringBuilder();
    for (double[] corner : new double[][] {{10, 1.5}, {30, 1.5}, {30, 7}, {10, 7}}) {
      GeoPosition at = frame.toGeo(new LocalPosition(corner[0], corner[1], 0));
      corners.append(String.format(Locale.ROOT, " %.9f,%.9f", at.latitude(), at.longitude()));
    }
    return corners.toString();
  }

  @Test
  void bothContinueWhileTheRadioIsCutAndReportTheGapWhenItIsRestored() throws Exception {
    for (int i = 0; i < 2; i++) {
      RobotHost host = hosts.get(i);
      String begin = "search " + host.robot() + " " + (i == 0 ? "forth" : "back") + region();
      patiently().until(() -> host.ask(begin).endsWith(" RUNNING"));
    }
    for (int i = 0; i < 2; i++) {
      RobotHost host = hosts.get(i);
      String other = hosts.get(1 - i).robot();
      patiently().until(() -> host.ask("listen " + other).equals(other));
      patiently().until(() -> done(host) > 0);
      patiently().until(() -> received(host, other, 0) >= 2);
      patiently().until(() -> host.ask("mate " + host.robot()).endsWith(" reachable"));
    }
    compareClocks();
    Map<String, String> before = new TreeMap<>();
    patiently()
        .untilAsserted(
            () -> {
              before.clear();
              before.putAll(hosts.get(0).list());
              assertThat(before).isEqualTo(hosts.get(1).list());
              assertThat(before.values())
                  .hasSize(2 * modules("atrv1"))
                  .allMatch(each -> each.endsWith("/fresh"));
            });
    for (RobotHost host : hosts) {
      // On a busy machine a robot may stand still for some seconds, which is reported as a gap too.
      assertThat(longestGap(host).map(Gap::seconds).orElse(0L))
          .as(host.ask("gaps " + host.robot()))
          .isLessThan(CUT.toSeconds() / 2);
    }

    double[] doneBefore = {done(hosts.get(0)), done(hosts.get(1))};
    long cut = System.nanoTime();
    network.disconnect();
    for (int i = 0; i < 2; i++) {
      awaitAlone(hosts.get(i), hosts.get(1 - i).robot());
    }
    await()
        .ignoreException(NumberFormatException.class)
        .pollDelay(CUT.minusNanos(System.nanoTime() - cut))
        .atMost(CUT.plus(PATIENCE))
        .until(() -> done(hosts.get(0)) > doneBefore[0] && done(hosts.get(1)) > doneBefore[1]);
    for (RobotHost host : hosts) {
      patiently()
          .untilAsserted(
              () ->
                  assertThat(host.ask("progress " + host.robot()))
                      .matches("[\\d.]+ (RUNNING|SUCCEEDED)"));
      System.out.printf("%s alone: done %s%n", host.robot(), host.ask("progress " + host.robot()));
    }
    long alone = Duration.ofNanos(System.nanoTime() - cut).toSeconds();
    network.reconnect();

    for (int i = 0; i < 2; i++) {
      RobotHost host = hosts.get(i);
      patiently().untilAsserted(() -> assertThat(host.list()).isEqualTo(before));
      assertGap(host, hosts.get(1 - i).robot(), alone);
    }
    compareClocks();
  }

  private static void awaitAlone(RobotHost host, String other) throws Exception {
    patiently().until(() -> host.ask("received " + other).endsWith(" interrupted"));
    patiently().until(() -> host.ask("mate " + host.robot()).endsWith(" lost"));
    patiently()
        .until(
            () ->
                host.list().entrySet().stream()
                    .filter(each -> each.getKey().startsWith(other))
                    .noneMatch(each -> each.getValue().endsWith("/fresh")));
    patiently()
        .untilAsserted(
            () ->
                assertThat(host.ask("gaps " + host.robot())).contains(other + " is out of reach"));
  }

  /** What the client missed of the other's search, and the robot of the other's poses. */
  private static void assertGap(RobotHost host, String other, long seconds) throws Exception {
    patiently().until(() -> host.ask("received " + other).endsWith(" listening"));
    patiently().until(() -> received(host, other, 1) > 0);
    patiently()
        .untilAsserted(
            () ->
                assertThat(longestGap(host).map(Gap::seconds).orElse(0L))
                    .as(host.ask("gaps " + host.robot()))
                    .isGreaterThanOrEqualTo(seconds - 1));
    Gap gap = longestGap(host).orElseThrow();
    System.out.printf(
        "%s reports: %s; the client beside it received, lost of its search: %s%n",
        host.robot(), gap.text(), host.ask("received " + other));
    assertThat(gap.robot()).isEqualTo(other);
    // Poses come ten times a second; on a busy machine fewer.
    assertThat(gap.missed()).as(gap.text()).isGreaterThan(seconds);
    patiently().until(() -> host.ask("mate " + host.robot()).endsWith(" reachable"));
  }

  /** A gap that is over, as a robot reports it. */
  private record Gap(String robot, long seconds, long missed, String text) {}

  private static Optional<Gap> longestGap(RobotHost host) throws Exception {
    return GAP.matcher(host.ask("gaps " + host.robot()))
        .results()
        .map(
            each ->
                new Gap(
                    each.group(1),
                    Long.parseLong(each.group(2)),
                    Long.parseLong(each.group(3)),
                    each.group()))
        .max(Comparator.comparingLong(Gap::seconds));
  }

  /** Each robot's measure of the other's clock against what was set. */
  private static void compareClocks() throws Exception {
    for (int i = 0; i < 2; i++) {
      RobotHost host = hosts.get(i);
      int sign = i == 0 ? 1 : -1;
      patiently().untilAsserted(() -> compareClock(host, sign));
    }
  }

  private static void compareClock(RobotHost host, int sign) throws Exception {
    String[] teammate = host.ask("mate " + host.robot()).split(" ");
    double ahead = DRIFT * Duration.between(SKEWED_FROM, Instant.now()).toMillis() / 1e3;
    double measured = sign * Double.parseDouble(teammate[0]);
    System.out.printf(
        "clock of atrv2 against atrv1, by %s: %.4f s within %s s, set to %.4f s; %s m apart%n",
        host.robot(), measured, teammate[1], ahead, teammate[2]);
    // An eighth of what the clocks differ by: a busy machine receives even the soonest fix late.
    assertThat(measured).as(String.join(" ", teammate)).isBetween(ahead - 0.1, ahead + 0.1);
  }

  private static double done(RobotHost host) throws Exception {
    return Double.parseDouble(host.ask("progress " + host.robot()).split(" ")[0]);
  }

  private static long received(RobotHost host, String path, int column) throws Exception {
    return Long.parseLong(host.ask("received " + path).split(" ")[column]);
  }
}
