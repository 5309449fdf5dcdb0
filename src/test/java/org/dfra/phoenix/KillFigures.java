package org.dfra.phoenix;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.dfra.core.time.Timing;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.measurement.RunMeasurements;

/** What was measured of a process that is killed again and again. Confined to one thread. */
final class KillFigures {

  private final Duration target;
  private final List<Timing> back = new ArrayList<>();
  private int kills;
  private int kept;

  /**
   * @param target within which 95 of 100 kills should have it back
   */
  KillFigures(Duration target) {
    this.target = target;
  }

  /** It is about to be killed. */
  void killed() {
    kills++;
  }

  /** It is of use again. */
  void back(Timing timing) {
    back.add(timing);
  }

  /** All that it is to keep was found kept after the last kill. */
  void kept() {
    kept++;
  }

  /** How often it was killed. */
  int kills() {
    return kills;
  }

  /** The time within which that share of the kills had it back. */
  Timing quantile(double share) {
    List<Timing> sorted = back.stream().sorted(Comparator.comparing(Timing::took)).toList();
    return sorted.get(Math.max(1, (int) Math.ceil(share * sorted.size())) - 1);
  }

  /** The figures, as benchmarks have them. */
  RunMeasurements figures() {
    RunMeasurements figures = new RunMeasurements();
    figures.add(new MeasuredValue("kills", kills, Double.POSITIVE_INFINITY, ""));
    figures.add(
        new MeasuredValue("kills after which state was lost", (double) kills - kept, 0, ""));
    if (!back.isEmpty()) {
      figures.add(seconds("back after kill -9, median", 0.5, Double.POSITIVE_INFINITY));
      figures.add(seconds("back after kill -9, p95", 0.95, target.toNanos() / 1e9));
      figures.add(seconds("back after kill -9, longest", 1, Double.POSITIVE_INFINITY));
    }
    return figures;
  }

  private MeasuredValue seconds(String what, double share, double most) {
    return new MeasuredValue(what, quantile(share).took().toNanos() / 1e9, most, "s");
  }

  /** Appends them to a file, with date and machine. */
  void record(Path file) throws IOException {
    figures().append(file, "soak", "killed-module");
  }
}
