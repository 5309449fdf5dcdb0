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
 * The end of a module's driver. The first caller closes it; until that has returned, the driver may
 * use its device, and whoever needs to know that it does not awaits it here. {@link
 * ModuleImpl#close} cannot be asked: it returns at once where another thread has begun it.
 */
final class DriverShutdown implements AutoCloseable {

  private final ModuleImpl driver;
  private final AtomicBoolean begun = new AtomicBoolean();
  private final CompletableFuture<@Nullable Void> closed = new CompletableFuture<>();

  DriverShutdown(ModuleImpl driver) {
    this.driver = driver;
  }

  /** Closes the driver where it moves the robot, unless somebody has begun to. Never throws. */
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
    } catch (RuntimeException | Error e) { // close, and whoever awaits it, report it
      closed.completeExceptionally(e);
    }
  }

  /** Whether somebody has begun to close the driver. */
  boolean hasBegun() {
    return begun.get();
  }

  /**
   * Closes the driver, unless somebody has begun to: it is not waited for then.
   *
   * @throws IllegalStateException if it has gone wrong; the cause says how
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
   * @throws IllegalStateException if its end has gone wrong; the cause says how
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
