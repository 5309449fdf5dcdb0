package org.dfra.core.effector;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Instant;
import java.time.InstantSource;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandRefusedByEmergencyStopException;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.LeaseRefusedByEmergencyStopException;
import org.dfra.lease.LeaseHandle;
import org.dfra.lease.LeaseRefusedException;
import org.jspecify.annotations.Nullable;

/**
 * Arbitrates the command of an effector: at most one lease holder commands it.
 *
 * <p>Commands, and the stop that follows the loss of a commander, are mutually exclusive. Once a
 * key is invalid, no command with it begins, and the device stops before any other command begins.
 * Releasing, acquiring or ending the command by an emergency stop does not wait for a command in
 * progress: the stop is pending until that command ends.
 */
public final class CommandArbiter {

  /** Grants the lease of the commander. */
  @FunctionalInterface
  public interface LeaseGrantor {

    /**
     * @param onEnd to be run once when the lease ends for any reason
     * @return the lease's ID, a secret of holder and grantor
     */
    UUID grant(Runnable onEnd) throws LeaseRefusedException;
  }

  private record Commander(CommandKey key, String name, Instant since) {}

  private final String module;
  private final InstantSource clock;
  private final Runnable lost;
  private final Runnable heldUp;
  private final Consumer<Runnable> halts;
  private final EmergencyStopLatch stop;
  private final Consumer<UUID> revoke;

  /** Held while a command is executed or the device is stopped; taken before this. */
  private final ReentrantLock acting = new ReentrantLock();

  private volatile @Nullable Commander commander; // written with the lock of this held

  @GuardedBy("this")
  private @Nullable UUID lease;

  /**
   * A stop is pending: a commander was lost, and the device has not stopped since; cleared under
   * acting.
   */
  private volatile boolean isStopOwed;

  private volatile @Nullable CommandKey
      stopped; // written with the lock of this held; deposed by the last stop

  /**
   * @param module the effector's path, {@code robot/name}
   * @param lost run when the commander is lost, before any command of another is executed; must not
   *     block, nor throw
   * @param heldUp run before that, once, if the commander is lost and its last command does not end
   *     within a tenth of a second; must not throw
   * @param halts runs tasks that may wait for the driver; it waits for them only briefly
   * @param stop the latch; no commands are accepted while it is latched
   * @param revoke ends a lease whose holder is not the commander
   */
  CommandArbiter(
      String module,
      InstantSource clock,
      Runnable lost,
      Runnable heldUp,
      Consumer<Runnable> halts,
      EmergencyStopLatch stop,
      Consumer<UUID> revoke) {
    this.module = module;
    this.clock = clock;
    this.lost = lost;
    this.heldUp = heldUp;
    this.halts = halts;
    this.stop = stop;
    this.revoke = revoke;
  }

  /**
   * Makes a client the commander. Never waits for the driver: if the driver blocks, the first
   * command waits.
   *
   * @param name the client's name, for display
   * @param grantor grants the lease; called only if there is no commander
   * @throws LeaseRefusedException if there is a commander, the effector is in an emergency stop, or
   *     no lease is granted
   */
  public CommandKey acquire(String name, LeaseGrantor grantor) throws LeaseRefusedException {
    CommandKey key = new CommandKey(UUID.randomUUID());
    begin(new Commander(key, name, clock.instant()));
    @Nullable UUID granted = null;
    try {
      granted = grantor.grant(() -> release(key));
    } finally {
      if (granted == null) {
        giveUp(key);
      }
    }
    synchronized (this) {
      if (isHeldBy(key)) {
        lease = granted;
        return key;
      }
    }
    revoke.accept(granted); // it was deposed meanwhile, or the lease has ended
    refuseALeaseWhileStopped();
    return key;
  }

  private void refuseALeaseWhileStopped() throws LeaseRefusedException {
    if (stop.isLatched()) {
      throw new LeaseRefusedByEmergencyStopException(stop.refusalMessage());
    }
  }

  private synchronized void begin(Commander next) throws LeaseRefusedException {
    refuseALeaseWhileStopped(); // a stop latches first, so no client can acquire it after depose
    @Nullable Commander other = commander;
    if (other != null) {
      throw new LeaseRefusedException(
          module
              + " is commanded by "
              + other.name()
              + " since "
              + other.since()
              + "; wait until it releases its lease, or have its lease"
              + (lease == null ? "" : " " + LeaseHandle.of(lease))
              + " revoked");
    }
    commander = next;
  }

  /**
   * Executes a command of the commander, before another client can become the commander.
   *
   * @throws CommandRefusedException if the key is not the commander's, or the effector is in an
   *     emergency stop
   */
  void execute(CommandKey key, Runnable command) {
    refuseACommandWhileStopped(); // also while the driver blocks
    refuseUnlessHeldBy(key); // likewise; and a refused command does not delay the pending stop
    acting.lock();
    try {
      refuseACommandWhileStopped();
      refuseUnlessHeldBy(key);
      if (isStopOwed) {
        stopIfOwed(); // of an earlier commander, whose command blocked the driver
        refuseACommandWhileStopped(); // that may have taken long
        refuseUnlessHeldBy(key);
      }
      command.run();
    } finally {
      acting.unlock();
    }
  }

  private void refuseACommandWhileStopped() {
    if (stop.isLatched()) {
      throw new CommandRefusedByEmergencyStopException(stop.refusalMessage());
    }
  }

  private void refuseUnlessHeldBy(CommandKey key) {
    if (key.equals(stopped)) {
      throw new CommandRefusedByEmergencyStopException(
          module
              + " was stopped for an emergency while this key commanded it, and was released"
              + " since; to move it again, request a new command lease");
    }
    if (!isHeldBy(key)) {
      @Nullable Commander other = commander;
      throw new CommandRefusedException(
          module
              + (other == null
                  ? " has no commander, and this key is not valid any more; request a command lease"
                  : " is commanded by "
                      + other.name()
                      + " since "
                      + other.since()
                      + "; this key is not, or no longer, its commander's"));
    }
  }

  /**
   * Deposes the commander for an emergency stop, without waiting for a command in progress. The
   * device must then be stopped; see {@link #runBetweenCommands}. The deposed commander's next
   * command is refused because of the stop, even if the effector was released by then: the client
   * must not re-acquire the lease and drive on.
   *
   * @return the commander's lease, which must be ended; null if there is none
   */
  synchronized @Nullable UUID revokeCommander() {
    @Nullable UUID over = lease;
    @Nullable Commander deposed = commander;
    if (deposed != null) {
      stopped = deposed.key();
      isStopOwed = true;
    }
    commander = null;
    lease = null;
    return over;
  }

  /**
   * Runs a task as soon as no command is in progress.
   *
   * @param meanwhile run before, once, if a command does not end within a tenth of a second
   */
  void runBetweenCommands(Runnable task, Runnable meanwhile) {
    if (!lockSoon()) {
      meanwhile.run();
      acting.lock();
    }
    try {
      task.run();
    } finally {
      acting.unlock();
    }
  }

  /** Whether no command is in progress, or the current one ends within a tenth of a second. */
  boolean awaitFree() {
    if (!lockSoon()) {
      return false;
    }
    acting.unlock();
    return true;
  }

  private boolean lockSoon() {
    try {
      return acting.tryLock() // also for an interrupted thread
          || acting.tryLock(100, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /** Whether there is a commander, and this is its key. */
  public boolean isHeldBy(CommandKey key) {
    @Nullable Commander now = commander;
    return now != null && now.key().equals(key);
  }

  /** The commander's name, for display; null while there is none. */
  @Nullable String commander() {
    @Nullable Commander now = commander;
    return now == null ? null : now.name();
  }

  /** No lease was granted, so there never was a commander: no stop is needed. */
  private synchronized void giveUp(CommandKey key) {
    if (isHeldBy(key)) {
      commander = null;
    }
  }

  private void release(CommandKey key) {
    if (letGo(key)) {
      stopIfDue();
    }
  }

  private synchronized boolean letGo(CommandKey key) {
    boolean isHeld = isHeldBy(key);
    if (isHeld) {
      commander = null;
      lease = null;
      isStopOwed = true;
    }
    return isHeld;
  }

  /**
   * Closes the arbiter when the effector ends. Deposes the commander, also if its lease has ended
   * and {@link #release} has not run yet; call {@link #stopIfDue} afterwards.
   */
  synchronized void close() {
    if (commander != null) {
      commander = null;
      lease = null;
      isStopOwed = true;
    }
  }

  /** Stops the device if a stop is pending; waits for its driver only briefly. */
  void stopIfDue() {
    if (isStopOwed) {
      halts.accept(() -> runBetweenCommands(this::stopIfOwed, this::heldUpIfOwed));
    }
  }

  /**
   * The command that blocked the driver may have ended, and the next commander's may be in
   * progress.
   */
  private void heldUpIfOwed() {
    if (isStopOwed) {
      heldUp.run();
    }
  }

  /** Whether there is no commander, or its first command has not begun. */
  boolean isStopDue() {
    return isStopOwed || commander == null;
  }

  /** Called between commands. */
  private void stopIfOwed() {
    if (isStopOwed) {
      isStopOwed = false; // a commander that is lost from now on requires another stop
      lost.run();
    }
  }

  /** The device was stopped in another way; called between commands. */
  void markStopped() {
    isStopOwed = false;
  }
}
