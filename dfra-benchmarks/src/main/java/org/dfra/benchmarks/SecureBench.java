package org.dfra.benchmarks;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.dfra.benchmarks.secure.RecoveryTask;
import org.dfra.benchmarks.secure.RecoveryTask.Recovery;
import org.dfra.benchmarks.secure.RevocationTask;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.geometry.GeoPosition;

/**
 * Measures how fast a revocation is in force, how long connections of members take, and how robots
 * of a team recover, beside open ones in turn.
 */
final class SecureBench implements Bench {

  private static final int TRIES = 1000;
  private static final int ROUNDS = 5;

  private static final double REVOCATION = 1000; // milliseconds
  private static final double HANDSHAKE = 150; // milliseconds
  private static final double RATIO = 1.3;
  private static final double P99 = 0.99;

  private static final List<GeoPosition> ANTENNAS =
      List.of(
          new GeoPosition(27.950603, -82.457200, 14.5),
          new GeoPosition(27.950597, -82.457200, 14.5));

  private final boolean isQuick;

  /**
   * @param isQuick whether it makes a short run, whose figures are inaccurate
   */
  SecureBench(boolean isQuick) {
    this.isQuick = isQuick;
  }

  @Override
  public void run(Report report) throws Exception {
    revocations(report);
    recoveries(report);
  }

  private void revocations(Report report) throws Exception {
    int tries = isQuick ? TRIES / 50 : TRIES;
    report.say(tries + " members are revoked, one after the other.");
    RevocationTask.Result result = RevocationTask.measure(tries);
    quantiles(report, "first call of a member, with its handshake", result.handshakes(), HANDSHAKE);
    quantiles(report, "revocation to refused call", result.calls(), REVOCATION);
    quantiles(report, "revocation to end of the lease", result.leases(), REVOCATION);
  }

  private static void quantiles(Report report, String what, double[] millis, double most) {
    report.figure(what + ", median", Report.quantile(millis, 1 / 2.0), "ms");
    report.figure(what + ", p99", Report.quantile(millis, P99), most, "ms");
    report.figure(what + ", longest", Report.quantile(millis, 1), "ms");
  }

  private void recoveries(Report report) throws Exception {
    Map<Recovery, List<Double>> open = new EnumMap<>(Recovery.class);
    Map<Recovery, List<Double>> secure = new EnumMap<>(Recovery.class);
    try (DemoEnvironment devices = new DemoEnvironment()) {
      List<String> links = devices.startReceivers(ANTENNAS);
      for (int round = 0; round < (isQuick ? 1 : ROUNDS); round++) {
        for (boolean isSecure : new boolean[] {round % 2 == 0, round % 2 != 0}) {
          Map<Recovery, Double> measured = RecoveryTask.measure(isSecure, links);
          measured.forEach(
              (what, seconds) ->
                  (isSecure ? secure : open)
                      .computeIfAbsent(what, key -> new ArrayList<>())
                      .add(seconds));
          report.say(
              "Round %d, %s: %s s.".formatted(round + 1, isSecure ? "secure" : "open", measured));
        }
      }
      devices.shutDown();
    }
    for (Recovery each : Recovery.values()) {
      double without = median(open, each);
      double with = median(secure, each);
      report.figure(each.label() + ", open", without, "s");
      report.figure(each.label() + ", secure", with, "s");
      report.figure(each.label() + ", secure over open", with / without, RATIO, "");
    }
  }

  private static double median(Map<Recovery, List<Double>> all, Recovery what) {
    return Report.quantile(
        all.getOrDefault(what, List.of()).stream().mapToDouble(Double::doubleValue).toArray(),
        1 / 2.0);
  }
}
