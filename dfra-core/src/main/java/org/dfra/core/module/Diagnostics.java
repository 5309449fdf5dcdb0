package org.dfra.core.module;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.locks.ReentrantLock;
import org.dfra.core.config.NearestName;
import org.dfra.core.config.RenamedNames;
import org.dfra.module.Diagnosis;
import org.dfra.time.Scheduler;
import org.slf4j.Logger;

/**
 * The tests and recovery methods of a module's hardware, by name. They run on their caller's
 * thread, one at a time.
 */
public final class Diagnostics {

  /** A test or recovery procedure. */
  @FunctionalInterface
  public interface DiagnosticProcedure {

    /**
     * Runs the procedure.
     *
     * @throws Exception if it cannot be run; that is reported as a finding too
     */
    DiagnosticFinding run() throws Exception;
  }

  /**
   * The finding of a procedure.
   *
   * @param passed whether no fault was found
   * @param text the finding, a sentence
   */
  public record DiagnosticFinding(boolean passed, String text) {}

  private final String module;
  private final InstantSource clock;
  private final Scheduler scheduler;
  private final Logger log;
  private final Map<String, DiagnosticProcedure> tests = new LinkedHashMap<>();
  private final Map<String, DiagnosticProcedure> recoveries = new LinkedHashMap<>();
  private final ReentrantLock oneAtATime = new ReentrantLock();

  Diagnostics(String module, InstantSource clock, Scheduler scheduler, Logger log) {
    this.module = module;
    this.clock = clock;
    this.scheduler = scheduler;
    this.log = log;
  }

  /** Declares a test; only while the module is constructed. */
  public void addTest(String name, DiagnosticProcedure check) {
    tests.put(name, check);
  }

  /** Declares a recovery method; only while the module is constructed. */
  public void addRecovery(String name, DiagnosticProcedure check) {
    recoveries.put(name, check);
  }

  List<String> tests() {
    return new ArrayList<>(tests.keySet());
  }

  List<String> recoveries() {
    return new ArrayList<>(recoveries.keySet());
  }

  Diagnosis runTest(String name) {
    return run(name, find("test", name, tests));
  }

  Diagnosis runRecovery(String name) {
    return run(name, find("recovery method", name, recoveries));
  }

  private DiagnosticProcedure find(
      String what, String name, Map<String, DiagnosticProcedure> known) {
    DiagnosticProcedure check =
        known.get(RenamedNames.resolve(module, "the " + what, name, known.keySet()));
    if (check == null) {
      throw new IllegalArgumentException(
          module
              + " knows no "
              + what
              + " \""
              + name
              + "\""
              + NearestName.hint(
                  name,
                  known.keySet(),
                  known.isEmpty()
                      ? "; it knows none at all"
                      : "; it knows " + String.join(", ", known.keySet())));
    }
    return check;
  }

  private Diagnosis run(String name, DiagnosticProcedure check) {
    oneAtATime.lock();
    try {
      Instant when = clock.instant();
      long began = scheduler.nanos();
      DiagnosticFinding finding = find(check);
      Duration took = Duration.ofNanos(scheduler.nanos() - began);
      log.info(
          "{}: {} {}: {}", module, name, finding.passed() ? "passed" : "failed", finding.text());
      return new Diagnosis(name, finding.passed(), finding.text(), when, took);
    } finally {
      oneAtATime.unlock();
    }
  }

  private DiagnosticFinding find(DiagnosticProcedure check) {
    try {
      return check.run();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return new DiagnosticFinding(false, "it was interrupted before its end");
    } catch (Exception e) { // as DiagnosticProcedure declares it: a driver's own
      log.warn("{}: an examination ended in an exception", module, e);
      return new DiagnosticFinding(false, "it could not be done: " + e);
    }
  }
}
