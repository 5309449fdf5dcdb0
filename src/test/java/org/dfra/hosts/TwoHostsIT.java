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
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.examples.mission.SparseField;
import org.dfra.testing.NetworkNamespaceHosts;
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

  /** A call's deadline of 2 s; 0.1 s for its timer and its thread. */
  private static final Duration CALL_ENDED = Duration.ofMillis(2100);

  /** Once a call has met its deadline, the next asks the activator first, for at most 1 s. */
  private static final Duration LATER_CALL_ENDED = CALL_ENDED.plusSeconds(1);

  /** The requirement for a silent peer: a deadline of 2 s, and 0.8 s between signs of life. */
  private static final Duration REPORTED = Duration.ofSeconds(3);

  @TempDir static Path folder;

  private static final StallProbe probe = StallProbe.start();
  private static NetworkNamespaceHosts network;
  private static List<RobotHost> hosts = List.of();

  @BeforeAll
  static void bringUpBothRobots() throws Exception {
    Optional<String> refusal = NetworkNamespaceHosts.unavailableReason();
    assumeTrue(refusal.isEmpty(), () -> refusal.orElse(""));
    network = new NetworkNamespaceHosts();
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
    try (NetworkNamespaceHosts removed = network) {
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
      for (String address : NetworkNamespaceHosts.ADDRESSES) {
        assertThat(host.ask("carried " + address).split(" "))
            .as("addresses in what the lookup service at " + address + " gives away")
            .contains(address)
            .isSubsetOf(NetworkNamespaceHosts.ADDRESSES);
      }
      assertThat(host.ask("requests").split(" "))
          .as("where multicast requests want their answers")
          .isNotEmpty()
          .isSubsetOf(NetworkNamespaceHosts.ADDRESSES);
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
      patiently().until(() -> received(host, elsewhere, 0) >= 2);
    }

    long watched = System.nanoTime();
    watchBoth();
    network.disconnect();
    long cut = System.nanoTime();
    Duration whole = Duration.ofNanos(cut - watched); // that the connection was whole, watched
    for (int i = 0; i < 2; i++) {
      RobotHost host = hosts.get(i);
      String elsewhere = hosts.get(1 - i).robot() + "/gps_front";
      String called = host.ask("call " + elsewhere);
      System.out.printf("a call over the cut connection, from %s: %s%n", host.robot(), called);
      assertThat(called).doesNotEndWith(" ok");
      timing(called)
          .requireWithin(
              "a call over the cut connection, with a deadline of 2 s,",
              i == 0 ? CALL_ENDED : LATER_CALL_ENDED);
      patiently().until(() -> host.ask("call " + host.robot() + "/gps_front").endsWith(" ok"));
      Timing reported = changed(host, elsewhere);
      reported
          .ofPart(reported.took().minus(whole))
          .requireWithin("reporting that a module is out of reach", REPORTED);
      assertThat(host.ask("received " + elsewhere)).endsWith(" interrupted");
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
        .pollInterval(Duration.ofMillis(FULL ? 100 : 500))
        .until(
            () ->
                hosts.get(0).ask("call atrv1/gps_rear").endsWith(" ok")
                    && hosts.get(1).ask("call atrv2/gps_rear").endsWith(" ok"));
    long[] received = {
      received(hosts.get(0), "atrv2/gps_front", 0), received(hosts.get(1), "atrv1/gps_front", 0)
    };

    watchBoth();
    StallProbe.Stopwatch mended = probe.stopwatch();
    network.reconnect();
    for (int i = 0; i < 2; i++) {
      RobotHost host = hosts.get(i);
      String address = NetworkNamespaceHosts.ADDRESSES.get(i);
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
      long already = received[i];
      patiently().until(() -> received(host, elsewhere, 0) > already);
      Timing listening = changed(host, elsewhere);
      System.out.printf(
          "%s listens again %.1f s after; received, lost: %s%n",
          host.robot(), listening.took().toMillis() / 1e3, host.ask("received " + elsewhere));
      listening.requireWithin("listening again after a cut", CONSISTENT);
      assertThat(received(host, elsewhere, 1)).as("the gap, counted").isPositive();
    }
    consistent.requireWithin("consistent personas after a cut", CONSISTENT);
  }

  /** Has both hosts time how long it takes until their subscriptions change. */
  private static void watchBoth() throws Exception {
    for (int i = 0; i < 2; i++) {
      hosts.get(i).ask("watch " + hosts.get(1 - i).robot() + "/gps_front");
    }
  }

  /** How long that took, by the host's own clock. */
  private static Timing changed(RobotHost host, String path) throws Exception {
    patiently().until(() -> !host.ask("changed " + path).equals("-"));
    return timing(host.ask("changed " + path));
  }

  /** A measurement at the begin of what a host has answered. */
  private static Timing timing(String answer) {
    String[] words = answer.split(" ");
    return new Timing(
        Duration.ofNanos(Long.parseLong(words[0])),
        Duration.ofNanos(Long.parseLong(words[1])),
        Double.parseDouble(words[2]),
        Duration.ofNanos(Long.parseLong(words[3])));
  }

  private static long received(RobotHost host, String path, int column) throws Exception {
    return Long.parseLong(host.ask("received " + path).split(" ")[column]);
  }
}
