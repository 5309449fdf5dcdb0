package org.dfra.cli.event;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.directory.ModuleListing;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.Subscription;
import org.dfra.module.Module;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.proxy.PendingLeaseCancellations;
import org.jspecify.annotations.Nullable;

/**
 * Subscribes to a module until an end condition holds, and then cancels the subscription.
 *
 * <p>Threads: the listener's events arrive on a thread of the subscription; {@link #run} waits on
 * its caller's. While this is open, a shutdown hook ends it when the process receives a signal to
 * terminate, and delays the exit until {@link #close}.
 */
final class ListeningSession implements AutoCloseable {

  private static final Duration TICK = Duration.ofSeconds(1);

  /** A call's timeout is 2 s, so unsubscribing takes no longer. */
  private static final Duration UNSUBSCRIBE_TIMEOUT = Duration.ofSeconds(3);

  /** Receives events, one at a time. */
  interface EventHandler {

    /**
     * Handles an event.
     *
     * @param lost total number of events lost so far
     * @return whether to continue
     */
    boolean onEvent(Delivery delivery, long lost);

    /**
     * Called every second.
     *
     * @return whether to continue
     */
    boolean onSecond(long lost);
  }

  private final ModuleListing<Module> module;
  private final EventHandler ear;
  private final CountDownLatch ended = new CountDownLatch(1);
  private final CountDownLatch closed = new CountDownLatch(1);
  private final AtomicLong left;
  private final Thread hook = new Thread(this::interrupted, "dfra-listening-end");
  private volatile @Nullable Subscription subscription;

  /**
   * @param count number of events after which the session ends
   */
  ListeningSession(ModuleListing<Module> module, EventHandler ear, long count) {
    this.module = module;
    this.ear = ear;
    this.left = new AtomicLong(count);
    Runtime.getRuntime().addShutdownHook(hook);
  }

  /**
   * Subscribes, and returns when the number of events or the time is reached, the handler ends the
   * session or the process is terminating.
   *
   * @return the number of events lost
   * @throws CommandFailure if an administrator has revoked the subscription
   */
  long run(DeliveryPolicy policy, Duration time) throws RemoteException, InterruptedException {
    long begin = System.nanoTime();
    Subscription open = module.module().subscribe(this::dispatch, policy);
    subscription = open;
    try {
      long elapsed = 0;
      while (elapsed < time.toNanos()) {
        long untilTick = TICK.toNanos() - elapsed % TICK.toNanos();
        long wait = Math.min(untilTick, time.toNanos() - elapsed);
        if (ended.await(wait, TimeUnit.NANOSECONDS)) {
          break;
        }
        if (!open.isOpen()) {
          throw new CommandFailure(
              ExitCode.FAILED,
              module.path() + " sends no more events: an administrator has revoked the lease");
        }
        elapsed = System.nanoTime() - begin;
        if (elapsed < time.toNanos() && wait == untilTick && !ear.onSecond(open.lost())) {
          break;
        }
      }
      ended.countDown(); // later events are ignored
      return open.lost();
    } finally {
      open.close();
      boolean unused = PendingLeaseCancellations.await(UNSUBSCRIBE_TIMEOUT);
    }
  }

  private void dispatch(Delivery delivery) {
    if (ended.getCount() == 0) {
      return;
    }
    @Nullable Subscription open = subscription; // null if events precede our return
    boolean isMoreWanted = ear.onEvent(delivery, open == null ? 0 : open.lost());
    if (left.decrementAndGet() <= 0 || !isMoreWanted) {
      ended.countDown();
    }
  }

  /** The process is terminating, for example by Ctrl-C: the main thread unsubscribes first. */
  private void interrupted() {
    ended.countDown();
    try {
      boolean unused = closed.await(UNSUBSCRIBE_TIMEOUT.plus(TICK).toNanos(), TimeUnit.NANOSECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Lets the process exit. */
  @Override
  public void close() {
    closed.countDown();
    try {
      boolean unused = Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      // the JVM is shutting down already, and the hook need not wait
      assert closed.getCount() == 0;
    }
  }
}
