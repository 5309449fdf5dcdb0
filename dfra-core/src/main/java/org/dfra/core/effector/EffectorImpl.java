package org.dfra.core.effector;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Locale;
import java.util.UUID;
import org.dfra.core.lease.LeaseRegistry;
import org.dfra.core.module.DeviceImpl;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.time.BootId;
import org.dfra.flow.effector.Command;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.Effector;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.LeaseRole;
import org.dfra.lifecycle.Incident;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.module.Precondition;
import org.dfra.persona.Attributes;
import org.dfra.persona.EmergencyStopAttributes;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * Base of every effector's driver. It guards the driver: only the commander's commands reach it,
 * whether the caller is in this virtual machine or remote, and none during an emergency stop.
 *
 * @param <C> its commands
 */
public abstract class EffectorImpl<C extends Command> extends DeviceImpl implements Effector<C> {

  /** Maximum wait for the driver in calls that must not block. */
  static final Duration DRIVER_TIMEOUT = Duration.ofMillis(100);

  /** Maximum wait of a lease release until the driver has stopped, as for an emergency stop. */
  private static final Duration STOP_TIMEOUT = Duration.ofMillis(500);

  private final Scheduler time;
  private final CommandArbiter arbiter;
  private final EmergencyStop stop;

  /**
   * See {@link org.dfra.core.module.ModuleImpl}.
   *
   * @param commandTypes the commands it accepts, by the simple names of their classes
   * @param outputTypes the types of its readings, by the simple names of their classes
   * @param preconditions the required conditions of its environment
   */
  protected EffectorImpl(
      ModuleContext context,
      String description,
      String author,
      String version,
      List<String> commandTypes,
      List<String> outputTypes,
      List<Precondition> preconditions) {
    super(context, description, author, version, commandTypes, outputTypes, preconditions);
    this.time = context.robotTime();
    EmergencyStopLatch latch =
        new EmergencyStopLatch(
            context.path(),
            context.state(),
            context.clock(),
            context.scheduler(),
            BootId.system(),
            log);
    this.arbiter =
        new CommandArbiter(
            context.path(),
            context.clock(),
            this::commanderLost,
            this::heldUp,
            this::haltSoon,
            latch,
            this::revoke);
    this.stop = new EmergencyStop(context.path(), latch, arbiter, new StopEnds());
  }

  /**
   * Executes a command of the commander, whose key has been checked. Calls do not overlap, are in
   * order, and are made while the module serves; must not block.
   *
   * @throws IllegalArgumentException if the device does not support this; the message names what it
   *     supports
   */
  protected abstract void execute(C command);

  /**
   * Maximum time that a command may wait while others block the driver, nanoseconds of the robot's
   * time; one that has waited longer is refused.
   */
  protected long maxCommandAge(C command) {
    return Long.MAX_VALUE;
  }

  /**
   * Stops the device safely when the commander is lost. Called between commands, also while the
   * module does not serve and while it is being closed; must not block.
   */
  protected abstract void stopSafely();

  /**
   * Called in an emergency stop while another thread executes a command in the driver and seems to
   * be blocked. A driver stops the device here if it can do so safely; {@link #stopSafely} follows
   * when the command ends. The default does nothing.
   */
  protected void stopDuringCommand() {}

  /**
   * Whether it has no commander, or the commander's first command has not begun; for {@link
   * #stopDuringCommand}, which may be late.
   */
  protected final boolean isStopDue() {
    return arbiter.isStopDue();
  }

  /**
   * Why it does not serve, as a clause for clients whose command is refused; null if there is no
   * reason to report.
   */
  protected @Nullable String unavailableReason() {
    return null;
  }

  private void commanderLost() {
    log.info("{}: it has no commander any more and stops", path());
    try {
      stopSafely();
    } catch (RuntimeException e) { // a driver's exception must not prevent the rest of the shutdown
      log.error("{}: it could not be stopped", path(), e);
      recordException(e);
    }
  }

  private void haltSoon(Runnable task) {
    boolean unused = haltWithin(task, STOP_TIMEOUT);
  }

  /**
   * Runs a task on the halt thread; the caller waits only briefly. If that thread cannot be
   * started, the task runs on the caller's, unless a command blocks the driver.
   *
   * @return whether it has ended
   */
  private boolean haltWithin(Runnable task, Duration patience) {
    if (haltExecutor().isPrepared()) {
      return haltExecutor().executeWithin(task, patience);
    }
    if (arbiter.awaitFree()) {
      task.run();
      return true;
    }
    heldUp();
    haltExecutor().execute(task); // which retries to start the thread
    return false;
  }

  /** A command in progress at the loss of the commander seems to be blocked. */
  private void heldUp() {
    if (readiness() != Readiness.STOPPED) { // the code that closes it has done so
      haltDuringCommand();
    }
  }

  /**
   * {@inheritDoc} Ending the commander's lease requires the end of the command in progress, and the
   * driver's stop; this method waits for both only briefly. The device is then closed, which may
   * unblock the driver.
   */
  @Override
  protected final void endLeases() {
    arbiter.close();
    if (arbiter.awaitFree()) { // and stays so: who commands from now on is refused
      if (!haltWithin(this::endLeasesAndSettle, DRIVER_TIMEOUT)) {
        log.warn("{}: its driver does not stop, and is closed nevertheless", path());
      }
      return;
    }
    log.warn("{}: a command is held up in its driver, which is closed nevertheless", path());
    boolean unused = haltExecutor().executeWithin(this::haltDuringCommand, DRIVER_TIMEOUT);
    haltExecutor().execute(this::endLeasesAndSettle);
  }

  /**
   * The commander, also one that is just releasing its lease, is deposed by now; a stop is pending.
   */
  private void endLeasesAndSettle() {
    super.endLeases();
    arbiter.stopIfDue();
  }

  /** Halts it during the command that blocks it, as far as its driver can. */
  final void haltDuringCommand() {
    try {
      stopDuringCommand();
    } catch (RuntimeException e) { // a driver's exception must not prevent the stop that follows
      log.error("{}: it could not be halted while it is held up", path(), e);
    }
  }

  private void revoke(UUID lease) {
    boolean unused = leases().revoke(lease);
  }

  private final class StopEnds implements EmergencyStop.Actions {

    @Override
    public void stopSafely() {
      EffectorImpl.this.stopSafely();
    }

    @Override
    public void stopDuringCommand() {
      haltDuringCommand();
    }

    /** Before start and after close there is no history to record in. */
    @Override
    public void recordIncident(Incident.Kind kind, String what) {
      log.warn("{}: {}", path(), what);
      Readiness readiness = readiness();
      if (readiness != Readiness.CREATED && readiness != Readiness.STOPPED) {
        EffectorImpl.this.recordIncident(kind, what);
      }
    }

    @Override
    public void revoke(UUID lease) {
      EffectorImpl.this.revoke(lease);
    }
  }

  @Override
  public final EmergencyStopState emergencyStop(@Nullable String by) {
    return stop.stop(by);
  }

  @Override
  public final EmergencyStopState releaseEmergencyStop(@Nullable String by) {
    return stop.release(by);
  }

  @Override
  public final EmergencyStopState emergencyStopState() {
    return stop.state();
  }

  /** {@inheritDoc} Includes the emergency-stop state. */
  @Override
  protected final List<? extends Attributes> categoryAttributes() {
    EmergencyStopState now = stop.state();
    return List.of(new EmergencyStopAttributes(now.latched(), now.requester(), now.since()));
  }

  @Override
  public final CommandLease acquireCommandLease(Duration duration) throws LeaseRefusedException {
    leases().terms().check(path(), duration);
    UUID[] lease = new UUID[1];
    CommandKey key =
        arbiter.acquire(
            "a module in its own virtual machine",
            whenOver -> lease[0] = leases().grantLocal(LeaseRole.COMMANDER, whenOver, whenOver));
    return new LocalCommandLease(leases(), lease[0], key, duration, clock());
  }

  @Override
  public final void execute(CommandKey key, C command) {
    long asked = time.nanos();
    arbiter.execute(
        key,
        () -> {
          refuseIfTooOld(command, time.nanos() - asked);
          Readiness readiness = readiness();
          if (!readiness.serves()) {
            @Nullable String awaits = unavailableReason();
            throw new NotReadyException(
                path(),
                readiness,
                "it cannot execute " + command + " now" + (awaits == null ? "" : ": " + awaits));
          }
          boolean unused =
              haltExecutor().isPrepared(); // for its end; a halt is executed without it, too
          execute(command);
        });
  }

  private void refuseIfTooOld(C command, long waited) {
    if (waited > maxCommandAge(command)) {
      throw new CommandRefusedException(
          String.format(
              Locale.ROOT,
              "%s was held up by an earlier command for %.1f s, so %s is too old and was not"
                  + " executed; send a new command",
              path(),
              waited / 1e9,
              command));
    }
  }

  /** Its command arbiter, for the server that exports it. */
  public final CommandArbiter commandArbiter() {
    return arbiter;
  }

  /** The commander's name, for display; null while there is none. */
  protected final @Nullable String commander() {
    return arbiter.commander();
  }

  /**
   * The lease of a commander in the effector's own virtual machine: it is valid until it is closed
   * or revoked, or the module ends.
   */
  private record LocalCommandLease(
      LeaseRegistry registry, UUID id, CommandKey key, Duration duration, InstantSource clock)
      implements CommandLease {

    @Override
    public Instant expiration() {
      return clock.instant().plus(duration);
    }

    @Override
    public boolean isLive() {
      return registry.contains(id);
    }

    @Override
    public void close() {
      boolean unused = registry.cancel(id);
    }
  }
}
