package org.dfra.attack.fuzz;

import java.io.IOException;
import java.nio.file.Path;
import org.dfra.attack.kit.Victim;
import org.dfra.benchmarks.attack.ProcessSample;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.measurement.RunMeasurements;

/**
 * How many changed messages of a kind were sent, how fast, and what the receiving process used
 * before the first and after the last. Confined to one thread.
 */
final class FuzzFigures {

  private static final double NO_TARGET = Double.POSITIVE_INFINITY;

  private final RunMeasurements figures = new RunMeasurements();
  private final long seed;

  /**
   * @param seed of the run's random numbers
   */
  FuzzFigures(long seed) {
    this.seed = seed;
  }

  /**
   * Notes one kind.
   *
   * @param kind what was sent, and where
   * @param count how many, until the last check
   * @param seconds how long that took, more than 0
   * @param failures how many checks failed
   */
  void add(String kind, int count, double seconds, int failures) {
    add(kind, "sent", count, NO_TARGET, "");
    add(kind, "rate", count / seconds, NO_TARGET, "1/s");
    add(kind, "failures", failures, 0, "");
  }

  /** Notes what the receiving process used before and after. */
  void addProcess(String kind, ProcessSample before, ProcessSample after) {
    add(kind, "threads before", before.threads(), NO_TARGET, "");
    add(kind, "threads after", after.threads(), (double) before.threads() + Victim.THREADS, "");
    add(kind, "heap before", before.heapBytes(), NO_TARGET, "B");
    add(kind, "heap after", after.heapBytes(), (double) before.heapBytes() + Victim.HEAP, "B");
  }

  private void add(String kind, String what, double value, double most, String unit) {
    figures.add(new MeasuredValue(kind + ": " + what, value, most, unit));
  }

  /** Appends them to a file, with the seed, date and machine. */
  void record(Path file) throws IOException {
    figures.append(file, "soak", "fuzz seed " + seed);
  }
}
