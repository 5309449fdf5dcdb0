package org.dfra.app.stop;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.dfra.river.call.Refusal;
import org.dfra.river.phoenix.stop.StopReport;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Orders every known phoenix to stop what it runs, each on a thread of its own and at once: no
 * lookup service and no proxy is needed for it.
 *
 * <p>A refused connection proves that no phoenix runs there. Anything else but a report is silence,
 * which proves nothing.
 */
final class PhoenixAnswers {

  private static final Logger LOG = LoggerFactory.getLogger(PhoenixAnswers.class);

  /** Addresses that are asked; anybody may announce lookup services on further computers. */
  private static final int LIMIT = 64;

  /** How one phoenix is ordered. */
  interface Order {
    /** Stops what is wanted. */
    StopReport stop() throws RemoteException;
  }

  private enum Kind {
    REPORTED,
    ABSENT,
    SILENT
  }

  /** One phoenix, and its answers so far. */
  private static final class Asked {
    final Order order;
    final List<StopReport> reports = new ArrayList<>(); // guarded by the outer object
    CompletableFuture<Kind> last = new CompletableFuture<>(); // guarded by the outer object

    Asked(Order order) {
      this.order = order;
    }
  }

  private final Duration patience;
  private final Executor threads;
  private final Consumer<StopReport> reported;
  private final Map<String, Asked> asked = new LinkedHashMap<>(); // guarded by this
  private @Nullable String unasked; // the first of those that are too many; guarded by this

  /**
   * @param patience for one of two tries
   * @param threads runs each order at once
   * @param reported is given each report as it comes, by any thread
   */
  PhoenixAnswers(Duration patience, Executor threads, Consumer<StopReport> reported) {
    this.patience = patience;
    this.threads = threads;
    this.reported = reported;
  }

  /**
   * Orders a phoenix, once.
   *
   * @param address {@code host:port}
   */
  synchronized void ask(String address, Order order) {
    if (asked.containsKey(address)) {
      return;
    }
    if (asked.size() >= LIMIT) {
      if (unasked == null) {
        unasked = address;
        LOG.warn("No phoenix is asked at {} and further addresses: {} were asked.", address, LIMIT);
      }
      return;
    }
    Asked one = new Asked(order);
    one.last = twice(one);
    asked.put(address, one);
  }

  private CompletableFuture<Kind> twice(Asked one) {
    return once(one)
        .exceptionallyCompose(
            failure -> isAbsent(failure) ? CompletableFuture.failedFuture(failure) : once(one))
        .exceptionally(
            failure -> {
              LOG.debug("No phoenix has reported.", failure);
              return isAbsent(failure) ? Kind.ABSENT : Kind.SILENT;
            });
  }

  private static boolean isAbsent(Throwable failure) {
    Throwable cause = failure;
    while (cause instanceof CompletionException && cause.getCause() != null) {
      cause = cause.getCause();
    }
    return Refusal.isProvenBy(cause);
  }

  private CompletableFuture<Kind> once(Asked one) {
    return CompletableFuture.supplyAsync(
            () -> {
              try {
                StopReport report = one.order.stop();
                synchronized (this) { // also one that comes too late to be awaited
                  one.reports.add(report);
                }
                reported.accept(report);
                return Kind.REPORTED;
              } catch (RemoteException e) {
                throw new CompletionException(e);
              }
            },
            threads)
        .orTimeout(patience.toMillis(), TimeUnit.MILLISECONDS);
  }

  /** Is done when every phoenix that was asked by now has answered, or will not. */
  synchronized CompletableFuture<Void> answered() {
    return CompletableFuture.allOf(
        asked.values().stream().map(each -> each.last).toArray(CompletableFuture<?>[]::new));
  }

  /** Orders those once more that have reported. */
  synchronized void askAgain() {
    for (Asked one : asked.values()) {
      if (!one.reports.isEmpty()) {
        one.last = twice(one);
      }
    }
  }

  /** What they say by now. */
  synchronized Confirmations now() {
    List<List<StopReport>> reports = new ArrayList<>();
    List<String> silent = new ArrayList<>();
    asked.forEach(
        (address, one) -> {
          reports.add(List.copyOf(one.reports));
          if (one.reports.isEmpty() && one.last.getNow(Kind.SILENT) == Kind.SILENT) {
            silent.add(address);
          }
        });
    @Nullable String further = unasked;
    if (further != null) {
      silent.add(further); // it may run what nobody else confirms
    }
    return Confirmations.of(reports, silent);
  }
}
