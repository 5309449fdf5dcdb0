package org.dfra.behaviors.perceptual.pose;

import java.util.Arrays;
import java.util.List;
import org.dfra.behaviors.perceptual.pose.PositionEstimatorImpl.TrackerKind;

/** Prints how good the trackers are, in Markdown: 20 seeds, ten minutes each. Run its main. */
final class TrackerTable {

  private static final int SEEDS = 20;
  private static final double SECONDS = 600;
  private static final double FROM = 30;

  private TrackerTable() {}

  public static void main(String[] args) {
    System.out.println("| errors | assumed | tracker | RMS m | worst m | yaw RMS rad | NEES |");
    System.out.println("|---|---|---|---|---|---|---|");
    Field.Errors white = Field.Errors.WHITE;
    for (double bias : List.of(0.0, 0.3, 1.5)) {
      row("gyro, bias " + bias, white.withBias(bias), "bias " + bias, settings(bias));
    }
    row("gyro, bias 0", white, "bias 1.5", settings(1.5));
    row("no gyro, turn slip 0.1, bias 0", white.withoutGyro(0.1), "bias 0", settings(0));
    row("no gyro, turn slip 0.3, bias 0", white.withoutGyro(0.3), "bias 0", settings(0));
    row(
        "no gyro, turn slip 0.3, bias 1.5",
        white.withBias(1.5).withoutGyro(0.3),
        "bias 1.5",
        settings(1.5));
  }

  static TrackerSettings settings(double biasSigma) {
    return TrackerSettings.DEFAULT.with(TrackerSettings.GpsErrors.DEFAULT.withBias(biasSigma));
  }

  private static void row(
      String name, Field.Errors errors, String assumed, TrackerSettings settings) {
    for (TrackerKind kind : TrackerKind.values()) {
      double[] rms = new double[SEEDS];
      double[] worst = new double[SEEDS];
      double[] yaw = new double[SEEDS];
      double[] nees = new double[SEEDS];
      for (int seed = 0; seed < SEEDS; seed++) {
        Field field = new Field(seed, errors, SECONDS);
        Ride ride = new Ride(field, kind.create(settings, "r/map", Field.DATUM));
        ride.go(FROM).compare(FROM, SECONDS);
        rms[seed] = ride.rms();
        worst[seed] = ride.worst();
        yaw[seed] = ride.yawRms();
        nees[seed] = ride.nees();
      }
      System.out.printf(
          "| %s | %s | %s | %.3f | %.2f | %.4f | %s |%n",
          name,
          assumed,
          kind,
          rootMeanSquare(rms),
          Arrays.stream(worst).max().orElse(0),
          rootMeanSquare(yaw),
          kind == TrackerKind.KALMAN
              ? String.format("%.2f", Arrays.stream(nees).average().orElse(0))
              : "");
    }
  }

  static double rootMeanSquare(double[] values) {
    return Math.sqrt(Arrays.stream(values).map(each -> each * each).average().orElse(0));
  }
}
