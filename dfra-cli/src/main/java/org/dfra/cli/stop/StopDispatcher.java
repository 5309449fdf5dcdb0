package org.dfra.cli.stop;

import com.google.errorprone.annotations.concurrent.GuardedBy;
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
import org.dfra.cli.stop.Outcome.Result;
import org.dfra.cli.stop.PhoenixAddresses.Address;
import org.dfra.cli.stop.PhoenixAddresses.Origin;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.phoenix.stop.StopReport;
import org.jspecify.annotations.Nullable;

/**
 * Calls all effectors in parallel, each on a thread of its own: an unresponsive effector does not
 * delay the others, and thousands of unresponsive ones, which any client may register, cause only a
 * short delay ({@link FairCallScheduler}). A call that fails or times out is repeated once.
 *
 * <p>An effector can be reached in three ways: by the phoenix of its robot, by its proxy from a
 * lookup service, and on its own host by phoenix's administrator. {@link StopMerge} combines their
 * answers.
 *
 * <p>Threads: {@code dfra-stop}, one for each running call; {@link #close} abandons unanswered
 * calls.
 */
final class StopDispatcher implements AutoCloseable {

  /**
   * Of each of two attempts. A stop waits up to half a second for its driver, and writes to a disk.
   */
  static final Duration ATTEMPT_TIMEOUT = Duration.ofSeconds(3);

  /** Number of further requests to phoenixes whose groups have not confirmed. */
  private static final int PHOENIX_RETRIES = 2;

  private record PendingCall(String path, CompletableFuture<Outcome> outcome) {}

  /** An effector in a lookup service: any client may register another proxy under its ID. */
  private record Listing(UUID id, UUID registrar) {}

  private final Result failed;
  private final Duration patience;
  private final Consumer<Outcome> well;
  private final StopMerge merge;
  private final ExecutorService threads = Executors.newCachedThreadPool(StopDispatcher::thread);
  private final FairCallScheduler listedCalls;
  private final PhoenixStopRequests phoenixes;

  @GuardedBy("this")
  private final Map<Listing, PendingCall> listed = new LinkedHashMap<>();

  // by registrar
  @GuardedBy("this")
  private final Map<UUID, Set<String>> hosts = new HashMap<>();

  @GuardedBy("this")
  private final Map<String, List<PendingCall>> local = new LinkedHashMap<>();

  @GuardedBy("this")
  private final List<CompletableFuture<Void>> searches = new ArrayList<>();

  private int questions =
      PHOENIX_RETRIES; // remaining retries; used by the thread that waits for the outcomes

  /**
   * @param failed the outcome for an effector that was not reached
   * @param patience timeout of one of two attempts
   * @param isTimeLeft whether to retry after two unanswered requests to a phoenix
   * @param well receives the outcome of each successful effector without delay, on any thread;
   *     except of those that only {@link #callLocal} reaches
   * @param merge combines the answers
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
   * Sends a stop request to a phoenix, unless it has received one. Pass all configured phoenixes
   * before discovered ones.
   *
   * @param origin the source of the address; the report of a configured phoenix counts
   */
  void requestPhoenix(Address address, Origin origin, PhoenixStopRequests.StopRequest order) {
    phoenixes.request(address, origin, order);
  }

  /**
   * Adds a discovered lookup service. Send the request to the phoenix of its computer before this
   * call: reports of its proxies are not published before its host is known.
   *
   * @param registrar its service ID
   * @param host that it claims; if several claim to be it, each counts
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

  /** The confirmations of the phoenixes so far. */
  Confirmations confirmations() {
    return phoenixes.confirmations();
  }

  /**
   * Calls an effector that a lookup service lists, unless it was called already by the entry of
   * this lookup service. The entry of another lookup service under that ID is called too: one of
   * the two may be forged, and must not replace the other.
   *
   * @param id its ID
   * @param registrar the lookup service
   * @param peer the address in its proxy; null if it has none
   * @param path {@code robot/name}
   * @param call calls it, and returns its outcome
   */
  synchronized void callListed(
      UUID id, UUID registrar, @Nullable PeerAddress peer, String path, Callable<Outcome> call) {
    Listing listing = new Listing(id, registrar);
    if (!listed.containsKey(listing)) {
      String robot = StopMerge.robotOf(path);
      PendingCall asked =
          new PendingCall(path, twice(path, () -> listedCalls.call(registrar, peer, robot, call)));
      listed.put(listing, asked);
      CompletableFuture<Void> unused =
          asked
              .outcome()
              .thenCombine(
                  phoenixes.answered(), (outcome, answered) -> counted(listing, path, outcome))
              .thenAccept(counts -> counts.ifPresent(well));
    }
  }

  /** The outcome, if it is successful and the proxy's own report counts. */
  private Optional<Outcome> counted(Listing listing, String path, Outcome outcome) {
    synchronized (this) {
      if (!hosts.containsKey(listing.registrar())) {
        return Optional.empty(); // it counts at the end, unless the phoenix there contradicts it
      }
    }
    UUID id = listing.id();
    Confirmations now = phoenixes.confirmations();
    if (now.knows(id, path) || !outcome.result().isWell()) {
      return Optional.empty(); // published with its phoenix's report, or at the end
    }
    StopMerge.ProxyClaim claim = new StopMerge.ProxyClaim(id, path, null, outcome);
    return merge.merge(List.of(claim), Map.of(), now).stream()
        .filter(each -> each.equals(outcome))
        .findFirst();
  }

  /**
   * Searches for the effectors of this host on a thread of its own; each is called as soon as it is
   * found.
   *
   * @param search calls {@link #callLocal} for each
   */
  synchronized void findLocal(Runnable search) {
    searches.add(
        CompletableFuture.runAsync(search, threads)
            .exceptionally(
                failure -> { // effectors found otherwise are still reported
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

  /** One line: the causes of remote failures are on lines of their own. */
  private String reason(Throwable failure) {
    Throwable cause = RetryPolicy.cause(failure);
    if (cause instanceof TimeoutException) {
      return "it did not answer within " + patience.toMillis() / 1e3 + " s, twice";
    }
    @Nullable String message = cause.getMessage();
    return message == null ? cause.toString() : message.lines().findFirst().orElse("").strip();
  }

  /**
   * Waits for all calls and returns the outcome for each effector. The first call repeats the
   * requests to phoenixes that have not confirmed everything.
   */
  List<Outcome> awaitOutcomes() {
    List<CompletableFuture<Void>> searching;
    synchronized (this) {
      searching = List.copyOf(searches);
    }
    searching.forEach(CompletableFuture::join); // effectors that they find count too
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
      phoenixes.retry(); // late effectors, or those started in order to be stopped
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
