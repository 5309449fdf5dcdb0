package org.dfra.core.effector;

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
 * Who commands an effector: one holder of a lease at the most.
 *
 * <p>Commands, and the rest that follows the loss of a commander, exclude each other. Once a key
 * does not count any more, no command that comes with it begins, and the device comes to rest
 * before any other command begins. Whoever gives the command up, takes it or ends it with an
 * emergency stop does not wait for a command that is under way: the rest is owed until that is
 * over.
 */
public final class CommandArbiter {

  /** Grants the lease that goes with the helm. */
  @FunctionalInterface
  public interface LeaseGrantor {

    /**
     * @param onEnd to be run once when the lease is over, in whichever way
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

  /** Held while a command is obeyed or the device comes to rest; taken before this. */
  private final ReentrantLock acting = new ReentrantLock();

  private volatile @Nullable Commander commander; // written under this
  private @Nullable UUID lease; // guarded by this

  /** A commander was lost, and the device has not come to rest since; cleared under acting. */
  private volatile boolean isStopOwed;

  private volatile @Nullable CommandKey stopped; // written under this; deposed by the last stop

  /**
   * @param module the effector's path, {@code robot/name}
   * @param lost run when the commander is lost, before any command of another is executed; must not
   *     block, nor throw
   * @param heldUp run before that, once, where the commander is lost and its last command does not
   *     end within a tenth of a second; must not throw
   * @param halts runs what may have to wait for the driver, and does not wait for it for long
   * @param stop nobody commands while it is latched
   * @param revoke ends a lease that goes with no command
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
   * Makes someone the commander. Never waits for the driver: where that is held up, the first
   * command does.
   *
   * @param name who it is, for people
   * @param grantor grants the lease; called only where the helm is free
   * @throws LeaseRefusedException if there is a commander, the effector is stopped for an
   *     emergency, or no lease is granted
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
    revoke.accept(granted); // it was deposed meanwhile, or the lease is over by now
    refuseALeaseWhileStopped();
    return key;
  }

  private void refuseALeaseWhileStopped() throws LeaseRefusedException {
    if (stop.isLatched()) {
      throw new LeaseRefusedByEmergencyStopException(stop.refusalMessage());
    }
  }

  private synchronized void begin(Commander next) throws LeaseRefusedException {
    refuseALeaseWhileStopped(); // who stops it latches first, so nobody slips in after depose
    @Nullable Commander other = commander;
    if (other != null) {
      throw new LeaseRefusedException(
          module
              + " is commanded by "
              + other.name()
              + " since "
              + other.since()
              + "; wait until it lets go, or have its lease"
              + (lease == null ? "" : " " + LeaseHandle.of(lease))
              + " revoked");
    }
    commander = next;
  }

  /**
   * Does what the commander says, before anybody else can become the commander.
   *
   * @throws CommandRefusedException if the key is not the commander's, or the effector is stopped
   *     for an emergency
   */
  void execute(CommandKey key, Runnable command) {
    refuseACommandWhileStopped(); // also while the driver is held up
    refuseUnlessHeldBy(key); // likewise; and who is refused does not delay the rest that is owed
    acting.lock();
    try {
      refuseACommandWhileStopped();
      refuseUnlessHeldBy(key);
      stopIfOwed(); // of an earlier commander, whose command held the driver up
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
              + " was stopped for an emergency while this key commanded it, and was released since;"
              + " whoever is to move it again asks it for a new command lease");
    }
    if (!isHeldBy(key)) {
      @Nullable Commander other = commander;
      throw new CommandRefusedException(
          module
              + (other == null
                  ? " has no commander, and this key counts no longer; ask it for a command lease"
                  : " is commanded by "
                      + other.name()
                      + " since "
                      + other.since()
                      + "; this key is not, or no longer, its commander's"));
    }
  }

  /**
   * Takes the command from whoever has it, for an emergency, without waiting for a command that is
   * under way. The device is to come to rest then; see {@link #runBetweenCommands}. Who is deposed
   * is told of the stop with its next command, also when the effector was released by then: it is
   * not to take the lease anew and drive on.
   *
   * @return the commander's lease, which is to end; null where there is none
   */
  synchronized @Nullable UUID depose() {
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
   * Does something as soon as no command is under way.
   *
   * @param meanwhile done before, once, where a command does not end within a tenth of a second
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

  /** Whether no command is under way, or the one that is ends within a tenth of a second. */
  boolean awaitFree() {
    if (!lockSoon()) {
      return false;
    }
    acting.unlock();
    return true;
  }

  private boolean lockSoon() {
    try {
      return acting.tryLock() // also for a thread that is interrupted
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

  /** Who commands, for people; null while nobody does. */
  @Nullable String commander() {
    @Nullable Commander now = commander;
    return now == null ? null : now.name();
  }

  /** No lease was granted, so there never was a commander: nothing comes to rest. */
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
   * The effector ends. Takes the command from whoever has it, also where its lease has ended and
   * {@link #release} has not been reached; {@link #stopIfDue} is to follow.
   */
  synchronized void close() {
    if (commander != null) {
      commander = null;
      lease = null;
      isStopOwed = true;
    }
  }

  /**
   * Has the device come to rest where it owes that; waits for its driver for a moment at the most.
   */
  void stopIfDue() {
    if (isStopOwed) {
      halts.accept(() -> runBetweenCommands(this::stopIfOwed, this::heldUpIfOwed));
    }
  }

  /** The command that held the driver up may be over by now, and the next commander's under way. */
  private void heldUpIfOwed() {
    if (isStopOwed) {
      heldUp.run();
    }
  }

  /** Whether nobody commands, or the next commander's first command has not begun. */
  boolean isStopDue() {
    return isStopOwed || commander == null;
  }

  /** Between commands. */
  private void stopIfOwed() {
    if (isStopOwed) {
      isStopOwed = false; // a commander that is lost from now on wants more than this
      lost.run();
    }
  }

  /** The device has come to rest otherwise; between commands. */
  void markStopped() {
    isStopOwed = false;
  }
}
