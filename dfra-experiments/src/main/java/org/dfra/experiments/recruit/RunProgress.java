package org.dfra.experiments.recruit;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.dfra.experiments.recruit.simulation.Experiment;
import org.dfra.report.progress.ProgressReporter;

/**
 * Reports the progress of an experiment: on a terminal by a bar that is redrawn, elsewhere in a
 * sentence every ten seconds.
 */
final class RunProgress implements Experiment.Progress {

  private static final long REDRAW = TimeUnit.MILLISECONDS.toNanos(200);
  private static final long SENTENCE = TimeUnit.SECONDS.toNanos(10);
  private static final int WIDE = 40;

  private final ProgressReporter progress;
  private final LongSupplier nanos;
  private final long began;

  @GuardedBy("this")
  private long reported;

  /**
   * @param nanos a monotonic real-time clock with any origin
   */
  RunProgress(ProgressReporter progress, LongSupplier nanos) {
    this.progress = progress;
    this.nanos = nanos;
    this.began = nanos.getAsLong();
    this.reported = began;
  }

  @Override
  public synchronized void done(int runs, int ofThem) {
    long now = nanos.getAsLong();
    boolean isLast = runs == ofThem && progress.isTerminal();
    if (now - reported < (progress.isTerminal() ? REDRAW : SENTENCE) && !isLast) {
      return;
    }
    reported = now;
    double left = (now - began) / 1e9 / runs * (ofThem - runs);
    if (progress.isTerminal()) {
      int full = (int) ((long) WIDE * runs / ofThem);
      progress.redraw(
          List.of(
              String.format(
                  Locale.ROOT,
                  "[%s%s] %3d %%  %d of %d runs, %.0f s left",
                  "#".repeat(full),
                  ".".repeat(WIDE - full),
                  100L * runs / ofThem,
                  runs,
                  ofThem,
                  left)));
      if (isLast) {
        progress.freezeLive();
      }
    } else {
      progress.say("%d of %d runs have finished; about %.0f s remain.", runs, ofThem, left);
    }
  }
}
