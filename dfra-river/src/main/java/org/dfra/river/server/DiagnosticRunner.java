package org.dfra.river.server;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.dfra.module.Diagnosable;
import org.dfra.module.Diagnosis;
import org.dfra.river.remote.RemoteDiagnostics.DiagnosticType;
import org.jspecify.annotations.Nullable;

/**
 * Runs the tests and recoveries of a server, each on a daemon thread of its own, and keeps the
 * results of the last {@value #REMEMBERED}. At most {@value #MOST} run at once, for all clients
 * together.
 */
final class DiagnosticRunner {

  private static final int REMEMBERED = 32;
  private static final int MOST = 4;

  private final String module;
  private final Diagnosable subject;
  private final Semaphore places = new Semaphore(MOST);
  private final Map<UUID, FutureTask<Diagnosis>> runs = new LinkedHashMap<>() { // guarded by itself
        @Override
        protected boolean removeEldestEntry(Map.Entry<UUID, FutureTask<Diagnosis>> eldest) {
          return size() > REMEMBERED;
        }
      };

  DiagnosticRunner(String module, Diagnosable subject) {
    this.module = module;
    this.subject = subject;
  }

  /**
   * Starts one.
   *
   * @throws IllegalStateException if the limit of runs is reached
   */
  UUID startRun(DiagnosticType sort, String name) throws RemoteException {
    boolean known =
        (sort == DiagnosticType.TEST ? subject.tests() : subject.recoveries()).contains(name);
    UUID id = UUID.randomUUID();
    if (known) {
      start(id, name, () -> run(sort, name));
    } else {
      Diagnosis unused = run(sort, name); // throws: the name is unknown
    }
    return id;
  }

  private Diagnosis run(DiagnosticType sort, String name) throws RemoteException {
    return sort == DiagnosticType.TEST ? subject.test(name) : subject.recover(name);
  }

  private void start(UUID id, String name, Callable<Diagnosis> diagnostics) {
    if (!places.tryAcquire()) {
      throw new IllegalStateException(
          module
              + " runs "
              + MOST
              + " tests and recoveries at once, and no more; begin \""
              + name
              + "\" when one of them has ended");
    }
    FutureTask<Diagnosis> run = new FutureTask<>(diagnostics);
    boolean isStarted = false;
    try {
      synchronized (runs) {
        runs.put(id, run);
      }
      Thread thread = new Thread(() -> runAndLeave(run), module + " " + name);
      thread.setDaemon(true);
      thread.start();
      isStarted = true;
    } finally {
      if (!isStarted) {
        places.release();
      }
    }
  }

  private void runAndLeave(FutureTask<Diagnosis> run) {
    try {
      run.run();
    } finally {
      places.release();
    }
  }

  @Nullable Diagnosis await(UUID id, Duration timeout) {
    FutureTask<Diagnosis> run;
    synchronized (runs) {
      run = runs.get(id);
    }
    if (run == null) {
      throw new IllegalArgumentException(
          module
              + " does not know this examination: it was activated again, or many others were"
              + " begun; begin it again");
    }
    try {
      return run.get(timeout.toNanos(), TimeUnit.NANOSECONDS);
    } catch (TimeoutException e) {
      return null;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return null;
    } catch (ExecutionException e) {
      throw new IllegalStateException(module + ": the examination ended in " + e.getCause(), e);
    }
  }
}
