package org.dfra.app.recruit;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.app.demo.harness.ProgressReporter;
import org.junit.jupiter.api.Test;

/** What is told while an experiment runs; its time is the test's. */
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
  void tellsASentenceEveryTenSecondsWhereThereIsNoTerminal() {
    assertThat(watch(false).strip().lines().map(String::strip))
        .hasSize(5)
        .startsWith("10.000 s  20 of 100 runs are done; it takes 40 s more.")
        .endsWith("50.000 s  100 of 100 runs are done; it takes 0 s more.");
  }

  @Test
  void drawsABarOnATerminal() {
    assertThat(watch(true))
        .contains("[" + "#".repeat(20) + ".".repeat(20) + "]  50 %  50 of 100 runs, 25 s left")
        .contains("[" + "#".repeat(40) + "] 100 %  100 of 100 runs, 0 s left");
  }
}
