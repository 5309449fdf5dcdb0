package org.dfra.experiments.recruit;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.report.progress.ProgressReporter;
import org.junit.jupiter.api.Test;

/** What is printed while an experiment runs; the test sets its time. */
class RunProgressTest {

  private final AtomicLong nanos = new AtomicLong();
  private final StringWriter out = new StringWriter();

  /** A hundred runs of half a second each. */
  private String watch(boolean isTerminal) {
    RunProgress progress =
        new RunProgress(
            new ProgressReporter(new PrintWriter(out, true), nanos::get, isTerminal), nanos::get);
    for (int i = 1; i <= 100; i++) {
      nanos.addAndGet(TimeUnit.MILLISECONDS.toNanos(500));
      progress.done(i, 100);
    }
    return out.toString();
  }

  @Test
  void printsASentenceEveryTenSecondsWhereThereIsNoTerminal() {
    assertThat(watch(false).strip().lines().map(String::strip))
        .hasSize(5)
        .startsWith("10.000 s  20 of 100 runs have finished; about 40 s remain.")
        .endsWith("50.000 s  100 of 100 runs have finished; about 0 s remain.");
  }

  @Test
  void drawsABarOnATerminal() {
    assertThat(watch(true))
        .contains("[" + "#".repeat(20) + ".".repeat(20) + "]  50 %  50 of 100 runs, 25 s left")
        .contains("[" + "#".repeat(40) + "] 100 %  100 of 100 runs, 0 s left");
  }
}
