package org.dfra.app.stop;

import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.dfra.app.stop.PhoenixAddresses.Address;
import org.dfra.river.call.Refusal;
import org.dfra.river.phoenix.stop.StopReport;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Orders every known phoenix to stop what it runs, each on a thread of its own and at once: no
 * lookup service and no proxy is needed for it. Those that are configured are all ordered; of those
 * that only discovery named, {@value #LIMIT}.
 *
 * <p>A refused connection proves that no phoenix runs there. Anything else but a report is silence,
 * which proves nothing.
 */
final class PhoenixAnswers {

  private static final Logger LOG = LoggerFactory.getLogger(PhoenixAnswers.class);

  /** Addresses of discovery that are asked; anybody may announce further ones. */
  private static final int LIMIT = 64;

  /** How one phoenix is ordered. */
  interface Order {
    /**
     * Stops what is wanted. It may wait for a name service.
     *
     * @return what has become of it; null where there is nothing to ask
     */
    @Nullable StopReport stop() throws RemoteException;
  }

  private enum Kind {
    REPORTED,
    ABSENT,
    SILENT
  }

  /** One phoenix, and its answers so far. */
  private static final class Asked {
    final Address address;
    final boolean isConfigured;
    final Order order;
    final List<StopReport> reports = new ArrayList<>(); // guarded by the outer object
    CompletableFuture<Kind> last = new CompletableFuture<>(); // guarded by the outer object

    Asked(Address address, boolean isConfigured, Order order) {
      this.address = address;
      this.isConfigured = isConfigured;
      this.order = order;
    }
  }

  private final Repetition configured;
  private final Repetition discovered;
  private final Executor threads;
  private final Consumer<StopReport> reported;
  private final Map<Address, Asked> asked = new LinkedHashMap<>(); // guarded by this
  private @Nullable Address unasked; // the first of those that are too many; guarded by this

  /**
   * @param repetition how often a phoenix is ordered that is configured and does not answer, and
   *     how long each order may take; others are ordered twice
   * @param threads runs each order at once
   * @param reported is given each report of a configured phoenix as it comes, by any thread
   */
  PhoenixAnswers(Repetition repetition, Executor threads, Consumer<StopReport> reported) {
    this.configured = repetition;
    this.discovered = new Repetition(repetition.each(), () -> false);
    this.threads = threads;
    this.reported = reported;
  }

  /**
   * Orders a phoenix, once. Name all that are configured before those of discovery.
   *
   * @param isConfigured whether the operator named it, or its computer
   */
  synchronized void ask(Address address, boolean isConfigured, Order order) {
    if (asked.containsKey(address)) {
      return;
    }
    long discovered = asked.values().stream().filter(each -> !each.isConfigured).count();
    if (!isConfigured && discovered >= LIMIT) {
      if (unasked == null) {
        unasked = address;
        LOG.warn("No phoenix is asked at {} and further addresses: {} were asked.", address, LIMIT);
      }
      return;
    }
    Asked one = new Asked(address, isConfigured, order);
    one.last = repeatedly(one);
    asked.put(address, one);
  }

  private CompletableFuture<Kind> repeatedly(Asked one) {
    return (one.isConfigured ? configured : discovered)
        .of(() -> once(one), PhoenixAnswers::isAbsent)
        .exceptionally(
            failure -> {
              LOG.debug("No phoenix has reported.", failure);
              return isAbsent(failure) ? Kind.ABSENT : Kind.SILENT;
            });
  }

  private static boolean isAbsent(Throwable failure) {
    return Refusal.isProvenBy(Repetition.cause(failure));
  }

  private CompletableFuture<Kind> once(Asked one) {
    return CompletableFuture.supplyAsync(
            () -> {
              try {
                @Nullable StopReport report = one.order.stop();
                if (report == null) {
                  return Kind.ABSENT;
                }
                synchronized (this) { // also one that comes too late to be awaited
                  one.reports.add(report);
                }
                if (one.isConfigured) {
                  reported.accept(report);
                }
                return Kind.REPORTED;
              } catch (RemoteException e) {
                throw new CompletionException(e);
              }
            },
            threads)
        .orTimeout(configured.each().toMillis(), TimeUnit.MILLISECONDS);
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
        one.last = repeatedly(one);
      }
    }
  }

  /** What they say by now. */
  synchronized Confirmations now() {
    List<PhoenixAnswer> answers = new ArrayList<>();
    for (Asked one : asked.values()) {
      boolean isSilent = one.reports.isEmpty() && one.last.getNow(Kind.SILENT) == Kind.SILENT;
      answers.add(PhoenixAnswer.of(one.address, one.isConfigured, isSilent, one.reports));
    }
    @Nullable Address further = unasked;
    if (further != null) { // it may run what nobody else confirms
      answers.add(PhoenixAnswer.of(further, false, true, List.of()));
    }
    return new Confirmations(answers);
  }
}
