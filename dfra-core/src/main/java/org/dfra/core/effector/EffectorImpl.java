package org.dfra.core.effector;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.UUID;
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
import org.dfra.module.Incident;
import org.dfra.module.NotReadyException;
import org.dfra.module.Precondition;
import org.dfra.module.Readiness;
import org.dfra.persona.Attributes;
import org.dfra.persona.EmergencyStopAttributes;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * Base of every effector's driver. It stands in front of the driver: what does not come from the
 * commander never reaches it, whether the caller is in this virtual machine or elsewhere, and
 * nothing does while it is stopped for an emergency.
 *
 * @param <C> what it can be told
 */
public abstract class EffectorImpl<C extends Command> extends DeviceImpl implements Effector<C> {

  /** How long somebody waits for the driver who must not wait for it. */
  static final Duration DRIVER_TIMEOUT = Duration.ofMillis(100);

  /** How long whoever gives the command up waits until the driver rests, as an emergency stop. */
  private static final Duration STOP_TIMEOUT = Duration.ofMillis(500);

  private final Scheduler time;
  private final CommandArbiter arbiter;
  private final EmergencyStop stop;

  /**
   * See {@link org.dfra.core.module.ModuleImpl}.
   *
   * @param commandTypes the commands it takes, by the simple names of their classes
   * @param outputTypes the types of what it tells, by the simple names of their classes
   * @param preconditions what its environment must be like
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
   * The commander, whose right has been looked at, wants this. Called one at a time, in order,
   * while the module serves; must not block.
   *
   * @throws IllegalArgumentException if the device cannot do this at all; the message says what it
   *     can
   */
  protected abstract void execute(C command);

  /**
   * For how long a command may have waited behind others that the driver was held up with,
   * nanoseconds of the robot's time; one that has waited longer is refused.
   */
  protected long maxCommandAge(C command) {
    return Long.MAX_VALUE;
  }

  /**
   * There is no commander any more: comes to rest, as safely as the device can. Called between
   * commands, also while the module does not serve and while it is being closed; must not block.
   */
  protected abstract void stopSafely();

  /**
   * It is stopped for an emergency, and a command is still under way in the driver, on another
   * thread, and seems to be held up. Does what can be done nevertheless; {@link #stopSafely}
   * follows when the command is over. Nothing, unless a driver can do something safely.
   */
  protected void stopDuringCommand() {}

  /**
   * Whether nobody commands it, or the next commander's first command has not begun; for {@link
   * #stopDuringCommand}, which may be late.
   */
  protected final boolean isStopDue() {
    return arbiter.isStopDue();
  }

  /**
   * Why it does not serve while it does not, as a clause, for those whose command is not obeyed;
   * null where there is nothing to be said.
   */
  protected @Nullable String unavailableReason() {
    return null;
  }

  private void commanderLost() {
    log.info("{}: it has no commander any more and comes to rest", path());
    try {
      stopSafely();
    } catch (RuntimeException e) { // a driver's fault must not keep others from ending their part
      log.error("{}: it could not be told to come to rest", path(), e);
      recordException(e);
    }
  }

  private void haltSoon(Runnable task) {
    boolean unused = haltWithin(task, STOP_TIMEOUT);
  }

  /**
   * On the thread for halts; whoever asks for it waits for a moment at the most. Where that thread
   * cannot be started, the caller's has to do, unless a command holds the driver up.
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
    haltExecutor().execute(task); // which tries again to start the thread
    return false;
  }

  /** A command that is under way when the commander is lost seems to be held up. */
  private void heldUp() {
    if (readiness() != Readiness.STOPPED) { // whoever ends it has done so
      haltDuringCommand();
    }
  }

  /**
   * {@inheritDoc} The end of the commander's lease waits for the command that is under way, and for
   * the driver to come to rest; this waits for either no longer than a moment. The device is closed
   * then: that may be all that sets the driver free.
   */
  @Override
  protected final void endLeases() {
    arbiter.close();
    if (arbiter.awaitFree()) { // and stays so: who commands from now on is refused
      if (!haltWithin(this::endLeasesAndSettle, DRIVER_TIMEOUT)) {
        log.warn("{}: its driver does not come to rest, and is closed nevertheless", path());
      }
      return;
    }
    log.warn("{}: a command is held up in its driver, which is closed nevertheless", path());
    boolean unused = haltExecutor().executeWithin(this::haltDuringCommand, DRIVER_TIMEOUT);
    haltExecutor().execute(this::endLeasesAndSettle);
  }

  /** Who has the command, or gives it up just now, has lost it by now; the rest is owed. */
  private void endLeasesAndSettle() {
    super.endLeases();
    arbiter.stopIfDue();
  }

  /** Halts it past the command that holds it up, as far as its driver can. */
  final void haltDuringCommand() {
    try {
      stopDuringCommand();
    } catch (RuntimeException e) { // a driver's fault must not keep it from the rest that follows
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

    /** Before its life and after it there is nothing to be noted in. */
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

  /** {@inheritDoc} Whether it is stopped for an emergency. */
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
              haltExecutor().isPrepared(); // for its end; a halt is obeyed without, too
          execute(command);
        });
  }

  private void refuseIfTooOld(C command, long waited) {
    if (waited > maxCommandAge(command)) {
      throw new CommandRefusedException(
          String.format(
              Locale.ROOT,
              "%s was held up by an earlier command for %.1f s, so %s is too old and was not"
                  + " executed; command anew",
              path(),
              waited / 1e9,
              command));
    }
  }

  /** Who commands it, for whoever serves it to the network. */
  public final CommandArbiter commandArbiter() {
    return arbiter;
  }

  /** Who commands it, for people; null while nobody does. */
  protected final @Nullable String commander() {
    return arbiter.commander();
  }
}
