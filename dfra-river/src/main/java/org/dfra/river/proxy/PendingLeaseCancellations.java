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
 * The leases that this program is just giving back. Closing a lease or a subscription does not wait
 * for the server, which may be silent; a program that ends right afterwards waits here, or else the
 * server counts it until the lease runs out.
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
   * Waits until everything that was closed before is given back, or could not be.
   *
   * @return false if that takes longer than {@code patience}
   */
  public static boolean await(Duration timeout) throws InterruptedException {
    try {
      CompletableFuture.allOf(UNDER_WAY.toArray(CompletableFuture[]::new))
          .get(timeout.toNanos(), TimeUnit.NANOSECONDS);
      return true;
    } catch (ExecutionException e) {
      return true; // one has failed, and all are over
    } catch (TimeoutException e) {
      return false;
    }
  }
}
