package org.dfra.app.event;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.app.terminal.CommandFailure;
import org.dfra.app.terminal.ExitCode;
import org.dfra.directory.ModuleListing;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.Subscription;
import org.dfra.module.Module;
import org.dfra.river.proxy.PendingLeaseCancellations;
import org.jspecify.annotations.Nullable;

/**
 * Listens to a module until there is a reason to end, and then tells the module so.
 *
 * <p>Threads: the listener's events come on a thread of the subscription; {@link #run} waits on its
 * caller's. A shutdown hook, there while this is open, ends it when the process is told to end, and
 * holds the process up until {@link #close}.
 */
final class ListeningSession implements AutoCloseable {

  private static final Duration TICK = Duration.ofSeconds(1);

  /** A call's deadline is 2 s, so a farewell takes no longer. */
  private static final Duration UNSUBSCRIBE_TIMEOUT = Duration.ofSeconds(3);

  /** Is told what is heard, one event at a time. */
  interface EventHandler {

    /**
     * An event.
     *
     * @param lost how many were lost altogether so far
     * @return whether somebody wants more of them
     */
    boolean onEvent(Delivery delivery, long lost);

    /**
     * Another second is over.
     *
     * @return whether somebody wants to go on
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
   * @param count how many events are enough
   */
  ListeningSession(ModuleListing<Module> module, EventHandler ear, long count) {
    this.module = module;
    this.ear = ear;
    this.left = new AtomicLong(count);
    Runtime.getRuntime().addShutdownHook(hook);
  }

  /**
   * Listens, and returns when enough was heard, the time is over, nobody wants more or the process
   * is to end.
   *
   * @return the events lost
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
              module.path() + " tells no more: an administrator has revoked the lease");
        }
        elapsed = System.nanoTime() - begin;
        if (elapsed < time.toNanos() && wait == untilTick && !ear.onSecond(open.lost())) {
          break;
        }
      }
      ended.countDown(); // what arrives from now on is not heard
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
    @Nullable Subscription open = subscription; // null where an event is faster than our own answer
    boolean isMoreWanted = ear.onEvent(delivery, open == null ? 0 : open.lost());
    if (left.decrementAndGet() <= 0 || !isMoreWanted) {
      ended.countDown();
    }
  }

  /** The process is to end, by Ctrl-C say: the main thread says farewell first. */
  private void interrupted() {
    ended.countDown();
    try {
      boolean unused = closed.await(UNSUBSCRIBE_TIMEOUT.plus(TICK).toNanos(), TimeUnit.NANOSECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Lets the process end. */
  @Override
  public void close() {
    closed.countDown();
    try {
      boolean unused = Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      // it is ending already, and the hook has nothing to wait for any more
      assert closed.getCount() == 0;
    }
  }
}
