package org.dfra.river.server;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicBoolean;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.robot.ShutdownOrder;
import org.jspecify.annotations.Nullable;

/**
 * The shutdown of a module's driver. The first caller closes the driver. Until that call has
 * returned, the driver may use its device; other threads can wait for this here. {@link
 * ModuleImpl#close} does not suffice: it returns at once if another thread has started it.
 */
final class DriverShutdown implements AutoCloseable {

  private final ModuleImpl driver;
  private final AtomicBoolean begun = new AtomicBoolean();
  private final CompletableFuture<@Nullable Void> closed = new CompletableFuture<>();

  DriverShutdown(ModuleImpl driver) {
    this.driver = driver;
  }

  /** Closes the driver if it moves the robot, unless this has started already. Never throws. */
  void halt() {
    if (ShutdownOrder.movesRobot(driver)) {
      closeOnce();
    }
  }

  private void closeOnce() {
    if (!begun.compareAndSet(false, true)) {
      return;
    }
    try {
      driver.close();
      closed.complete(null);
    } catch (RuntimeException | Error e) { // close and await report it
      closed.completeExceptionally(e);
    }
  }

  /** Whether the shutdown has started. */
  boolean hasBegun() {
    return begun.get();
  }

  /**
   * Closes the driver, unless this has started already: then it does not wait.
   *
   * @throws IllegalStateException if it has failed; the cause has the reason
   */
  @Override
  public void close() {
    closeOnce();
    try {
      closed.getNow(null);
    } catch (CompletionException e) {
      throw failure(e.getCause() == null ? e : e.getCause());
    }
  }

  /**
   * Waits until the driver is closed.
   *
   * @throws TimeoutException if it is not in that time
   * @throws IllegalStateException if the shutdown has failed; the cause has the reason
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  void await(Duration time) throws TimeoutException, InterruptedException {
    try {
      closed.get(time.toNanos(), TimeUnit.NANOSECONDS);
    } catch (ExecutionException e) {
      throw failure(e.getCause() == null ? e : e.getCause());
    }
  }

  private static IllegalStateException failure(Throwable cause) {
    return new IllegalStateException(
        cause.getMessage() == null ? cause.toString() : cause.getMessage(), cause);
  }
}
