package org.dfra.cli.doctor;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/** Runs all checks in parallel. */
final class CheckRunner {

  /** No check takes this long, unless the computer itself does not respond. */
  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private CheckRunner() {}

  /** The findings, in the order of the checks. */
  static List<Finding> run(List<Check> checks) throws InterruptedException {
    ExecutorService threads =
        Executors.newFixedThreadPool(
            checks.size(),
            task -> {
              Thread thread = new Thread(task, "dfra-doctor-check");
              thread.setDaemon(true);
              return thread;
            });
    try {
      List<Future<List<Finding>>> running =
          checks.stream().map(each -> threads.submit(each::run)).toList();
      List<Finding> findings = new ArrayList<>();
      for (int i = 0; i < checks.size(); i++) {
        findings.addAll(result(running.get(i), checks.get(i).subject()));
      }
      return findings;
    } finally {
      threads.shutdownNow();
    }
  }

  private static List<Finding> result(Future<List<Finding>> running, Subject subject)
      throws InterruptedException {
    try {
      return running.get(PATIENCE.toMillis(), TimeUnit.MILLISECONDS);
    } catch (ExecutionException e) {
      if (e.getCause() instanceof RuntimeException failure) {
        throw failure; // an internal error
      }
      throw new IllegalStateException("the check of " + subject.id() + " failed", e.getCause());
    } catch (TimeoutException e) {
      return List.of(
          Finding.fail(
              subject,
              "could not be looked at within " + DurationText.of(PATIENCE),
              "Look whether this computer is overloaded, or a disk or name server hangs."));
    }
  }

  /** Checks one aspect. It changes nothing, and ends within three seconds. */
  interface Check {

    /** The checked subject. */
    Subject subject();

    /** Runs the check. */
    List<Finding> run() throws InterruptedException;
  }
}
