package org.dfra.river.proxy;

import java.time.Duration;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * The lease cancellations of this program that are in progress. Closing a lease or a subscription
 * does not wait for the server, which may not answer. A program that exits right afterwards waits
 * here; otherwise the server counts the lease until it expires.
 */
public final class PendingLeaseCancellations {

  private static final Set<CompletableFuture<Void>> UNDER_WAY = ConcurrentHashMap.newKeySet();

  private PendingLeaseCancellations() {}

  static CompletableFuture<Void> run(Executor executor, Runnable giveBack) {
    CompletableFuture<Void> call = CompletableFuture.runAsync(giveBack, executor);
    UNDER_WAY.add(call);
    return call.whenComplete((nothing, failure) -> UNDER_WAY.remove(call));
  }

  /**
   * Waits until everything that was closed before is cancelled, or could not be.
   *
   * @return false if that takes longer than {@code timeout}
   */
  public static boolean await(Duration timeout) throws InterruptedException {
    try {
      CompletableFuture.allOf(UNDER_WAY.toArray(CompletableFuture[]::new))
          .get(timeout.toNanos(), TimeUnit.NANOSECONDS);
      return true;
    } catch (ExecutionException e) {
      return true; // one has failed, and all are complete
    } catch (TimeoutException e) {
      return false;
    }
  }
}
