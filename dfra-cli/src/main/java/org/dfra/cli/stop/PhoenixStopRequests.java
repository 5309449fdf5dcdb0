package org.dfra.cli.stop;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.dfra.cli.stop.PhoenixAddresses.Address;
import org.dfra.cli.stop.PhoenixAddresses.Origin;
import org.dfra.river.call.ConnectionRefusal;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.phoenix.stop.StopReport;
import org.dfra.river.transport.ServerNotAcceptedException;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Sends a stop request to every known phoenix, each on a thread of its own and in parallel: this
 * needs no lookup service and no proxy. All configured phoenixes get one, and at most {@value
 * #LIMIT} of those that were only discovered.
 *
 * <p>A refused connection proves that no phoenix runs there. Any other failure is no answer, which
 * proves nothing.
 */
final class PhoenixStopRequests {

  private static final Logger LOG = LoggerFactory.getLogger(PhoenixStopRequests.class);

  /** Maximum number of discovered addresses; any host may announce further ones. */
  private static final int LIMIT = 64;

  /** Sends a stop request to one phoenix. */
  interface StopRequest {
    /**
     * Stops the selected effectors. May wait for a name service.
     *
     * @return its report; null if the address is not to be queried
     */
    @Nullable StopReport stop() throws RemoteException;
  }

  private enum ResponseKind {
    REPORTED,
    ABSENT,
    SILENT
  }

  /** One phoenix, and its answers so far. */
  private static final class PhoenixRequest {
    final Address address;
    final Origin origin;
    final StopRequest order;
    final List<StopReport> reports = new ArrayList<>(); // guarded by the outer object
    boolean isAuthenticated = true; // as far as the mode can know; guarded by the outer object
    CompletableFuture<ResponseKind> last = new CompletableFuture<>(); // guarded by the outer object

    PhoenixRequest(Address address, Origin origin, StopRequest order) {
      this.address = address;
      this.origin = origin;
      this.order = order;
    }
  }

  private final RetryPolicy configured;
  private final RetryPolicy discovered;
  private final Executor threads;
  private final Consumer<StopReport> reported;

  @GuardedBy("this")
  private final Map<Address, PhoenixRequest> asked = new LinkedHashMap<>();

  // the first address beyond the limit
  @GuardedBy("this")
  private @Nullable Address unasked;

  /**
   * @param repetition retry policy and timeout for configured phoenixes that do not answer; others
   *     get two requests
   * @param threads runs each request without delay
   * @param reported receives each report of a configured phoenix as it arrives, on any thread
   */
  PhoenixStopRequests(RetryPolicy repetition, Executor threads, Consumer<StopReport> reported) {
    this.configured = repetition;
    this.discovered = new RetryPolicy(repetition.attemptTimeout(), () -> false);
    this.threads = threads;
    this.reported = reported;
  }

  /**
   * Sends a stop request to a phoenix, once. Pass all configured phoenixes before discovered ones.
   *
   * @param origin the source of the address
   */
  synchronized void request(Address address, Origin origin, StopRequest order) {
    if (asked.containsKey(address)) {
      return;
    }
    long discovered = asked.values().stream().filter(each -> !each.origin.isConfigured()).count();
    if (!origin.isConfigured() && discovered >= LIMIT) {
      if (unasked == null) {
        unasked = address;
        LOG.warn("No phoenix is asked at {} and further addresses: {} were asked.", address, LIMIT);
      }
      return;
    }
    PhoenixRequest one = new PhoenixRequest(address, origin, order);
    one.last = repeatedly(one);
    asked.put(address, one);
  }

  private CompletableFuture<ResponseKind> repeatedly(PhoenixRequest one) {
    return (one.origin.isConfigured() ? configured : discovered)
        .run(() -> once(one), PhoenixStopRequests::isAbsent)
        .exceptionally(
            failure -> {
              LOG.debug("No phoenix has reported.", failure);
              return isAbsent(failure) ? ResponseKind.ABSENT : ResponseKind.SILENT;
            });
  }

  private static boolean isAbsent(Throwable failure) {
    return ConnectionRefusal.isProvenBy(RetryPolicy.cause(failure));
  }

  private CompletableFuture<ResponseKind> once(PhoenixRequest one) {
    return CompletableFuture.supplyAsync(
            () -> {
              try {
                return take(one, one.order.stop(), true);
              } catch (RemoteException e) {
                if (ServerNotAcceptedException.isCauseOf(e)) {
                  return asStranger(one, e);
                }
                throw new CompletionException(e);
              }
            },
            threads)
        .orTimeout(configured.attemptTimeout().toMillis(), TimeUnit.MILLISECONDS);
  }

  /**
   * Repeats a request without an identity. A robot whose credentials cannot be used is closed, and
   * neither it nor a member can know the other; it lets itself be stopped by strangers. Nobody
   * knows who has answered, so the answer confirms nothing.
   *
   * @param refusal of the request with the identity
   */
  private ResponseKind asStranger(PhoenixRequest one, RemoteException refusal) {
    try {
      Optional<StopReport> report =
          CurrentIdentity.callAsStranger(() -> Optional.ofNullable(one.order.stop()));
      return take(one, report.orElse(null), false);
    } catch (RemoteException | SecurityException e) { // it lets no stranger stop it, either
      refusal.addSuppressed(e);
      throw new CompletionException(refusal);
    }
  }

  private ResponseKind take(
      PhoenixRequest one, @Nullable StopReport report, boolean isAuthenticated) {
    if (report == null) {
      return ResponseKind.ABSENT;
    }
    synchronized (this) { // also one that arrives after the wait
      one.reports.add(report);
      one.isAuthenticated &= isAuthenticated;
    }
    if (isAuthenticated && one.origin.isConfigured()) {
      reported.accept(report);
    }
    return ResponseKind.REPORTED;
  }

  /** Completes when every phoenix of the requests so far has answered or failed. */
  synchronized CompletableFuture<Void> answered() {
    return CompletableFuture.allOf(
        asked.values().stream().map(each -> each.last).toArray(CompletableFuture<?>[]::new));
  }

  /** Sends another request to those that have reported. */
  synchronized void retry() {
    for (PhoenixRequest one : asked.values()) {
      if (!one.reports.isEmpty()) {
        one.last = repeatedly(one);
      }
    }
  }

  /** Their reports so far. */
  synchronized Confirmations confirmations() {
    List<PhoenixAnswer> answers = new ArrayList<>();
    for (PhoenixRequest one : asked.values()) {
      boolean isSilent =
          one.reports.isEmpty() && one.last.getNow(ResponseKind.SILENT) == ResponseKind.SILENT;
      answers.add(
          isSilent
              ? PhoenixAnswer.unresponsive(one.address, one.origin)
              : PhoenixAnswer.of(
                  one.address, one.isAuthenticated ? one.origin : Origin.DISCOVERY, one.reports));
    }
    @Nullable Address further = unasked;
    if (further != null) { // it may run effectors that no other phoenix confirms
      answers.add(PhoenixAnswer.notAsked(further));
    }
    return new Confirmations(answers);
  }
}
