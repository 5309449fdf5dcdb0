package org.dfra.app.stop;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import org.dfra.app.stop.Outcome.Result;
import org.jspecify.annotations.Nullable;

/**
 * Calls all effectors at once, each on a thread of its own: one that is silent holds up no other.
 * Where a call fails or is not answered in time, it is made once more.
 *
 * <p>An effector may be reached in two ways: by its proxy from a lookup service, and on its own
 * host by phoenix. The second counts only where the first has failed or there is none.
 *
 * <p>Threads: {@code dfra-stop}, one for each call under way; {@link #close} abandons those that
 * are still not answered.
 */
final class StopRound implements AutoCloseable {

  /** For one of two tries. A stop waits for its driver for half a second, and writes to a disk. */
  static final Duration TRY = Duration.ofSeconds(3);

  private record Asked(String path, CompletableFuture<Outcome> outcome) {}

  private final Result failed;
  private final Duration patience;
  private final Consumer<Outcome> well;
  private final ExecutorService threads =
      Executors.newCachedThreadPool(
          task -> {
            Thread thread = new Thread(task, "dfra-stop");
            thread.setDaemon(true);
            return thread;
          });

  private final Map<UUID, Asked> listed = new LinkedHashMap<>(); // guarded by this
  private final Map<String, List<Asked>> local = new LinkedHashMap<>(); // guarded by this
  private final List<CompletableFuture<Void>> searches = new ArrayList<>(); // guarded by this

  /**
   * @param failed what has become of an effector that was not reached
   * @param patience for one of two tries
   * @param well is told at once of each effector that a lookup service holds and all is well with;
   *     by any thread
   */
  StopRound(Result failed, Duration patience, Consumer<Outcome> well) {
    this.failed = failed;
    this.patience = patience;
    this.well = well;
  }

  /**
   * Calls an effector that a lookup service holds; nothing happens where it was called already.
   *
   * @param id its identity
   * @param path {@code robot/name}
   * @param call calls it, and says what has become of it
   */
  synchronized void callListed(UUID id, String path, Callable<Outcome> call) {
    if (!listed.containsKey(id)) {
      Asked asked = new Asked(path, twice(path, call));
      listed.put(id, asked);
      CompletableFuture<Void> unused =
          asked
              .outcome()
              .thenAccept(
                  outcome -> {
                    if (outcome.result().isWell()) {
                      well.accept(outcome);
                    }
                  });
    }
  }

  /**
   * Looks for the effectors of this host on a thread of its own; each is called as it is found.
   *
   * @param search calls {@link #callLocal} for each
   */
  synchronized void findLocal(Runnable search) {
    searches.add(
        CompletableFuture.runAsync(search, threads)
            .exceptionally(
                failure -> { // what is found otherwise is reported all the same
                  callLocal(
                      "the effectors of this host",
                      () -> {
                        throw new CompletionException(failure);
                      });
                  return null;
                }));
  }

  /** Calls an effector of this host without any lookup service; see {@link #callListed}. */
  synchronized void callLocal(String path, Callable<Outcome> call) {
    local
        .computeIfAbsent(path, unused -> new ArrayList<>())
        .add(new Asked(path, twice(path, call)));
  }

  private CompletableFuture<Outcome> twice(String path, Callable<Outcome> call) {
    return once(call)
        .exceptionallyCompose(unused -> once(call))
        .exceptionally(failure -> new Outcome(path, failed, null, null, reason(failure)));
  }

  private CompletableFuture<Outcome> once(Callable<Outcome> call) {
    return CompletableFuture.supplyAsync(
            () -> {
              try {
                return call.call();
              } catch (Exception e) { // as Callable declares it; it is told as the reason
                throw new CompletionException(e);
              }
            },
            threads)
        .orTimeout(patience.toMillis(), TimeUnit.MILLISECONDS);
  }

  /** One line: the causes of remote failures are told on lines of their own. */
  private String reason(Throwable failure) {
    Throwable cause = failure;
    while (cause instanceof CompletionException && cause.getCause() != null) {
      cause = cause.getCause();
    }
    if (cause instanceof TimeoutException) {
      return "it did not answer within " + patience.toMillis() / 1e3 + " s, twice";
    }
    @Nullable String message = cause.getMessage();
    return message == null ? cause.toString() : message.lines().findFirst().orElse("").strip();
  }

  /** Waits for all that were called, and tells what has become of each. */
  List<Outcome> outcomes() {
    List<CompletableFuture<Void>> searching;
    synchronized (this) {
      searching = List.copyOf(searches);
    }
    searching.forEach(CompletableFuture::join); // what they find is counted
    List<Asked> byLookup;
    Map<String, List<Asked>> here;
    synchronized (this) {
      byLookup = List.copyOf(listed.values());
      here = new LinkedHashMap<>(local);
    }
    List<Outcome> outcomes = new ArrayList<>();
    for (Asked each : byLookup) {
      Outcome outcome = each.outcome().join();
      List<Asked> otherWays = here.getOrDefault(each.path(), List.of());
      if (otherWays.size() == 1) { // several of one name are several effectors: each has to stop
        here.remove(each.path());
        if (!outcome.result().isWell()) {
          Outcome other = otherWays.get(0).outcome().join();
          outcome = other.result().isWell() ? other : outcome;
        }
      }
      outcomes.add(outcome);
    }
    here.values().forEach(all -> all.forEach(each -> outcomes.add(each.outcome().join())));
    return outcomes;
  }

  @Override
  public void close() {
    threads.shutdownNow();
  }
}
