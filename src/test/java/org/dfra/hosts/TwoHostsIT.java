package org.dfra.hosts;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.awaitility.core.ConditionFactory;
import org.dfra.app.raster.SparseField;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.testing.TestHosts;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Two robots on two hosts, which find each other by multicast, lose each other and find each other
 * again. The connection is cut as radio is: silently. In the short form all of a robot is in one
 * process.
 */
@Timeout(600)
class TwoHostsIT {

  private static final boolean FULL = Boolean.getBoolean("dfra.full");
  private static final Duration PATIENCE = Duration.ofSeconds(60);

  /** Longer than a lease of 30 s and the three seconds after which silence counts. */
  private static final Duration CUT = Duration.ofSeconds(FULL ? 60 : 36);

  /** The requirement after a cut. */
  private static final Duration CONSISTENT = Duration.ofSeconds(10);

  /** A call's deadline of 2 s, a retry, and the client's start of the verb. */
  private static final Duration CALL_ENDED = Duration.ofSeconds(10);

  @TempDir static Path folder;

  private static final StallProbe probe = StallProbe.start();
  private static TestHosts network;
  private static List<RobotHost> hosts = List.of();

  @BeforeAll
  static void bringUpBothRobots() throws Exception {
    Optional<String> refusal = TestHosts.refusal();
    assumeTrue(refusal.isEmpty(), () -> refusal.orElse(""));
    network = new TestHosts();
    RobotHost first = host(0, "first");
    hosts = List.of(first);
    hosts = List.of(first, host(1, "second"));
    for (RobotHost host : hosts) {
      patiently()
          .untilAsserted(
              () ->
                  assertThat(host.list().keySet())
                      .as("seen from " + host.robot() + ": " + host.log())
                      .containsExactly(
                          "atrv1/gps_front",
                          "atrv1/gps_rear",
                          "atrv2/gps_front",
                          "atrv2/gps_rear"));
    }
  }

  private static RobotHost host(int number, String name) throws Exception {
    List<String> client = List.of(HostClient.class.getName());
    String robot = "atrv" + (number + 1);
    Path own = Files.createDirectory(folder.resolve(name));
    Path xml =
        FULL
            ? RobotHost.shipped("field", robot)
            : SparseField.robot("field", own, robot, "gps_front", Set.of());
    return new RobotHost(network, number, "field", xml, own, "real", client);
  }

  @AfterAll
  static void takeDown() throws Exception {
    probe.close();
    try (TestHosts removed = network) {
      for (RobotHost host : hosts) {
        host.close();
      }
      assertThat(removed == null).isEqualTo(hosts.isEmpty());
    }
  }

  private static ConditionFactory patiently() {
    return await().atMost(PATIENCE).pollInterval(Duration.ofMillis(100));
  }

  @Test
  void eachSeesBothRobotsAndNothingCarriesTheLoopback() throws Exception {
    for (RobotHost host : hosts) {
      patiently().until(() -> host.ask("robots").equals("[atrv1, atrv2]"));
      for (String address : TestHosts.ADDRESSES) {
        assertThat(host.ask("carried " + address).split(" "))
            .as("addresses in what the lookup service at " + address + " gives away")
            .contains(address)
            .isSubsetOf(TestHosts.ADDRESSES);
      }
      assertThat(host.ask("requests").split(" "))
          .as("where multicast requests want their answers")
          .isNotEmpty()
          .isSubsetOf(TestHosts.ADDRESSES);
    }
    patiently().untilAsserted(() -> assertThat(hosts.get(0).list()).isEqualTo(hosts.get(1).list()));
  }

  @Test
  void theyLoseEachOtherAndFindEachOtherAgain() throws Exception {
    Map<String, String> before = new TreeMap<>();
    patiently()
        .untilAsserted(
            () -> {
              before.clear();
              before.putAll(hosts.get(0).list());
              assertThat(before.values()).allMatch(each -> each.endsWith("/fresh"));
            });
    for (int i = 0; i < 2; i++) {
      RobotHost host = hosts.get(i);
      String elsewhere = hosts.get(1 - i).robot() + "/gps_front";
      patiently().until(() -> host.ask("call " + elsewhere).endsWith(" ok"));
      host.ask("listen " + elsewhere);
      patiently().until(() -> heard(host, elsewhere, 0) >= 2);
    }

    long cut = System.nanoTime();
    network.cut();
    for (int i = 0; i < 2; i++) {
      RobotHost host = hosts.get(i);
      String elsewhere = hosts.get(1 - i).robot() + "/gps_front";
      StallProbe.Stopwatch calling = probe.stopwatch();
      String[] call = host.ask("call " + elsewhere).split(" ");
      Timing called = calling.stop();
      System.out.printf("a call over the cut connection ended after %s ms: %s%n", call[0], call[1]);
      assertThat(call[1]).isNotEqualTo("ok");
      called.requireWithin("a call over the cut connection, with a deadline of 2 s,", CALL_ENDED);
      patiently().until(() -> host.ask("call " + host.robot() + "/gps_front").endsWith(" ok"));
      patiently().until(() -> host.ask("heard " + elsewhere).endsWith(" interrupted"));
      patiently()
          .until(
              () ->
                  host.list().entrySet().stream()
                      .noneMatch(
                          each ->
                              !each.getKey().startsWith(host.robot())
                                  && each.getValue().endsWith("/fresh")));
    }
    Duration rest = CUT.minusNanos(System.nanoTime() - cut);
    patiently()
        .atMost(rest.plus(PATIENCE))
        .during(rest)
        .until(
            () ->
                hosts.get(0).ask("call atrv1/gps_rear").endsWith(" ok")
                    && hosts.get(1).ask("call atrv2/gps_rear").endsWith(" ok"));
    long[] heard = {
      heard(hosts.get(0), "atrv2/gps_front", 0), heard(hosts.get(1), "atrv1/gps_front", 0)
    };

    StallProbe.Stopwatch mended = probe.stopwatch();
    network.mend();
    for (int i = 0; i < 2; i++) {
      RobotHost host = hosts.get(i);
      String address = TestHosts.ADDRESSES.get(i);
      patiently().until(() -> host.list().equals(before));
      patiently().until(() -> host.ask("registered " + address).equals("4"));
    }
    Timing consistent = mended.stop();
    System.out.printf(
        "personas are consistent %.1f s after a cut of %d s%n",
        consistent.took().toMillis() / 1e3, CUT.toSeconds());
    for (int i = 0; i < 2; i++) {
      RobotHost host = hosts.get(i);
      String elsewhere = hosts.get(1 - i).robot() + "/gps_front";
      long already = heard[i];
      patiently().until(() -> heard(host, elsewhere, 0) > already);
      patiently().until(() -> host.ask("heard " + elsewhere).endsWith(" listening"));
      System.out.printf(
          "listening again at most %.1f s after; received, lost: %s%n",
          mended.stop().took().toMillis() / 1e3, host.ask("heard " + elsewhere));
      assertThat(heard(host, elsewhere, 1)).as("the gap, counted").isPositive();
    }
    consistent.requireWithin("consistent personas after a cut", CONSISTENT);
  }

  private static long heard(RobotHost host, String path, int column) throws Exception {
    return Long.parseLong(host.ask("heard " + path).split(" ")[column]);
  }
}
