package org.dfra.app.stop;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.dfra.app.stop.Outcome.Result;
import org.dfra.app.stop.PhoenixAddresses.Address;
import org.dfra.river.phoenix.stop.StopReport;
import org.jspecify.annotations.Nullable;

/**
 * Calls all effectors at once, each on a thread of its own: one that is silent holds up no other,
 * and thousands that are silent, which anybody may register, hold up none for long ({@link
 * FairCallScheduler}). Where a call fails or is not answered in time, it is made once more.
 *
 * <p>An effector may be reached in three ways: by the phoenix of its robot, by its proxy from a
 * lookup service, and on its own host by phoenix's administrator. {@link StopMerge} decides what
 * their answers mean.
 *
 * <p>Threads: {@code dfra-stop}, one for each call under way; {@link #close} abandons those that
 * are still not answered.
 */
final class StopDispatcher implements AutoCloseable {

  /** For one of two tries. A stop waits for its driver for half a second, and writes to a disk. */
  static final Duration ATTEMPT_TIMEOUT = Duration.ofSeconds(3);

  /** How often phoenixes are asked again whose groups have not confirmed. */
  private static final int PHOENIX_RETRIES = 2;

  private record PendingCall(String path, CompletableFuture<Outcome> outcome) {}

  /** An effector in a lookup service: anybody may list another proxy under its identity. */
  private record Listing(UUID id, UUID registrar) {}

  private final Result failed;
  private final Duration patience;
  private final Consumer<Outcome> well;
  private final StopMerge merge;
  private final ExecutorService threads = Executors.newCachedThreadPool(StopDispatcher::thread);
  private final FairCallScheduler listedCalls;
  private final PhoenixStopRequests phoenixes;

  private final Map<Listing, PendingCall> listed = new LinkedHashMap<>(); // guarded by this
  private final Map<UUID, Set<String>> hosts = new HashMap<>(); // by registrar; guarded by this
  private final Map<String, List<PendingCall>> local = new LinkedHashMap<>(); // guarded by this
  private final List<CompletableFuture<Void>> searches = new ArrayList<>(); // guarded by this
  private int questions =
      PHOENIX_RETRIES; // that are left; by the thread that waits for the outcomes

  /**
   * @param failed what has become of an effector that was not reached
   * @param patience for one of two tries
   * @param isTimeLeft whether a phoenix that has not answered twice is ordered again
   * @param well is given the outcome of each effector at once that all is well with, by any thread;
   *     not of those that only {@link #callLocal} reaches
   * @param merge decides what the answers mean
   */
  StopDispatcher(
      Result failed,
      Duration patience,
      BooleanSupplier isTimeLeft,
      Consumer<Outcome> well,
      StopMerge merge) {
    this.failed = failed;
    this.patience = patience;
    this.well = well;
    this.merge = merge;
    this.listedCalls = new FairCallScheduler(FairCallScheduler.Limits.DEFAULT, patience);
    this.phoenixes =
        new PhoenixStopRequests(new RetryPolicy(patience, isTimeLeft), threads, this::publish);
  }

  private static Thread thread(Runnable task) {
    Thread thread = new Thread(task, "dfra-stop");
    thread.setDaemon(true);
    return thread;
  }

  /**
   * Orders a phoenix to stop what it runs; nothing happens where it was ordered already. Name all
   * that are configured before those of discovery.
   *
   * @param isConfigured whether the operator named it, or its computer: its word counts
   */
  void requestPhoenix(
      Address address, boolean isConfigured, PhoenixStopRequests.StopRequest order) {
    phoenixes.request(address, isConfigured, order);
  }

  /**
   * A lookup service was found. Order the phoenix of its computer before this is called: the word
   * of its proxies is not published before it is known where it runs.
   *
   * @param registrar its service ID
   * @param host where it says that it runs; each counts where several say to be it
   */
  synchronized void registrarFound(UUID registrar, String host) {
    hosts.computeIfAbsent(registrar, unused -> new LinkedHashSet<>()).add(host);
  }

  private void publish(StopReport report) {
    report.effectors().stream()
        .map(merge::ofPhoenix)
        .filter(each -> each.result().isWell())
        .forEach(well);
  }

  /** What the phoenixes have confirmed by now. */
  Confirmations confirmations() {
    return phoenixes.confirmations();
  }

  /**
   * Calls an effector that a lookup service holds; nothing happens where it was called already by
   * what this lookup service holds. What another one holds under that identity is called too: one
   * of both may be a stranger's, and must not take the other's place.
   *
   * @param id its identity
   * @param registrar the lookup service
   * @param path {@code robot/name}
   * @param call calls it, and says what has become of it
   */
  synchronized void callListed(UUID id, UUID registrar, String path, Callable<Outcome> call) {
    Listing listing = new Listing(id, registrar);
    if (!listed.containsKey(listing)) {
      String robot = StopMerge.robotOf(path);
      PendingCall asked =
          new PendingCall(path, twice(path, () -> listedCalls.call(registrar, robot, call)));
      listed.put(listing, asked);
      CompletableFuture<Void> unused =
          asked
              .outcome()
              .thenCombine(
                  phoenixes.answered(), (outcome, answered) -> counted(listing, path, outcome))
              .thenAccept(counts -> counts.ifPresent(well));
    }
  }

  /** The outcome, if it is well and counts by the proxy's own word. */
  private Optional<Outcome> counted(Listing listing, String path, Outcome outcome) {
    synchronized (this) {
      if (!hosts.containsKey(listing.registrar())) {
        return Optional.empty(); // it is in the end, if no phoenix there says otherwise
      }
    }
    UUID id = listing.id();
    Confirmations now = phoenixes.confirmations();
    if (now.knows(id, path) || !outcome.result().isWell()) {
      return Optional.empty(); // it was published as its phoenix reported it, or is in the end
    }
    StopMerge.ProxyClaim claim = new StopMerge.ProxyClaim(id, path, null, outcome);
    return merge.merge(List.of(claim), Map.of(), now).stream()
        .filter(each -> each.equals(outcome))
        .findFirst();
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
        .add(new PendingCall(path, twice(path, () -> once(call))));
  }

  private CompletableFuture<Outcome> twice(String path, Supplier<CompletableFuture<Outcome>> once) {
    return once.get()
        .exceptionallyCompose(
            failure ->
                RetryPolicy.cause(failure) instanceof FairCallScheduler.NotCalledException
                    ? CompletableFuture.failedFuture(failure)
                    : once.get())
        .exceptionally(failure -> new Outcome(path, failed, null, null, reason(failure)));
  }

  private CompletableFuture<Outcome> once(Callable<Outcome> call) {
    CompletableFuture<Outcome> answer = new CompletableFuture<>();
    threads.execute(
        () -> {
          try {
            answer.complete(call.call());
          } catch (Exception | Error e) { // a proxy may throw anything; it becomes the reason
            answer.completeExceptionally(e);
          }
        });
    return answer.orTimeout(patience.toMillis(), TimeUnit.MILLISECONDS);
  }

  /** One line: the causes of remote failures are told on lines of their own. */
  private String reason(Throwable failure) {
    Throwable cause = RetryPolicy.cause(failure);
    if (cause instanceof TimeoutException) {
      return "it did not answer within " + patience.toMillis() / 1e3 + " s, twice";
    }
    @Nullable String message = cause.getMessage();
    return message == null ? cause.toString() : message.lines().findFirst().orElse("").strip();
  }

  /**
   * Waits for all that were called and tells what has become of each. Phoenixes that have not
   * confirmed everything are asked again, by the first call only.
   */
  List<Outcome> awaitOutcomes() {
    List<CompletableFuture<Void>> searching;
    synchronized (this) {
      searching = List.copyOf(searches);
    }
    searching.forEach(CompletableFuture::join); // what they find is counted
    Map<Listing, PendingCall> byLookup;
    Map<String, List<PendingCall>> here;
    Map<UUID, Set<String>> places = new HashMap<>();
    synchronized (this) {
      hosts.forEach((registrar, all) -> places.put(registrar, Set.copyOf(all)));
      byLookup = new LinkedHashMap<>(listed);
      here = new LinkedHashMap<>(local);
    }
    List<StopMerge.ProxyClaim> claims = new ArrayList<>();
    byLookup.forEach(
        (listing, each) ->
            claims.addAll(
                claims(listing, each, places.getOrDefault(listing.registrar(), Set.of()))));
    Map<String, List<Outcome>> reached = new LinkedHashMap<>();
    here.forEach(
        (path, all) -> reached.put(path, all.stream().map(each -> each.outcome().join()).toList()));
    phoenixes.answered().join();
    while (questions > 0 && !phoenixes.confirmations().isComplete()) {
      questions--;
      phoenixes.retry(); // what was late, or started to be stopped
      phoenixes.answered().join();
    }
    return merge.merge(claims, reached, phoenixes.confirmations());
  }

  private static List<StopMerge.ProxyClaim> claims(
      Listing listing, PendingCall asked, Set<String> hosts) {
    Outcome outcome = asked.outcome().join();
    if (hosts.isEmpty()) {
      return List.of(new StopMerge.ProxyClaim(listing.id(), asked.path(), null, outcome));
    }
    return hosts.stream()
        .map(host -> new StopMerge.ProxyClaim(listing.id(), asked.path(), host, outcome))
        .toList();
  }

  @Override
  public void close() {
    threads.shutdownNow();
    listedCalls.close();
  }
}
