package org.dfra.drivers.uav.mavlink;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.dfra.core.effector.EffectorImpl;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.Ticker;
import org.dfra.drivers.uav.mavlink.MavlinkCatalogue.MessageIds;
import org.dfra.drivers.uav.mavlink.MavlinkConnection.MavlinkClient;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.Text;
import org.dfra.flow.effector.FlightCommand;
import org.dfra.flow.effector.FlightCommand.Arm;
import org.dfra.flow.effector.FlightCommand.GoTo;
import org.dfra.flow.effector.FlightCommand.TakeOff;
import org.dfra.flow.effector.FlightEffector;
import org.dfra.flow.effector.FlightState;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.module.Precondition;
import org.dfra.persona.Attributes;
import org.dfra.persona.EffectorAttributes;
import org.dfra.persona.FlightAttributes;
import org.jspecify.annotations.Nullable;

/**
 * The flight controller of a multicopter, over MAVLink 2: PX4 or ArduPilot.
 *
 * <p><b>What a caller must know.</b> {@link #execute} returns when the command has been written to
 * the link. The vehicle answers later, and may reject it:
 *
 * <ul>
 *   <li>a command is complete when {@link #flightState} shows it; wait for that, with a timeout
 *   <li>a command that is rejected, or not acknowledged within 2.8 s, is reported to listeners as
 *       an incident of the history, logged, and shown in the parameter {@code last_failure}, with
 *       the autopilot's status text if there is one; {@code last_command} shows the result of the
 *       last command in any case. Only commands without an acknowledgement are resent; temporarily
 *       rejected ones are not, because a late command is worse than a missing one
 *   <li>an impossible command is rejected immediately, with an {@link IllegalArgumentException}:
 *       climbing above {@code max_height}, disarming in the air, a GoTo from the ground
 *   <li>a new command replaces the last one, acknowledged or not
 * </ul>
 *
 * <p><b>Heights.</b> A {@link FlightCommand.GoTo} has its height above the ellipsoid, and so has
 * {@link FlightState#position}. MAVLink uses heights above mean sea level; the difference is taken
 * from {@code GPS_RAW_INT}, or from the parameter {@code geoid_separation} where the autopilot does
 * not report it. If neither is known there is no position, and a GoTo is rejected. {@link
 * FlightState#height} and {@code max_height} are above the take-off position.
 *
 * <p><b>Without a commander</b> the vehicle is stopped by {@link LossOfCommandFailsafe}: in the air
 * it holds its position. While this module runs it sends heartbeats to the vehicle; when these end,
 * after a crash or a lost link, the vehicle's own failsafe acts, which must be configured (PX4:
 * {@code NAV_DLL_ACT}, ArduPilot: {@code FS_GCS_ENABLE}).
 *
 * <p>Parameters, besides those of {@link MavlinkLinkHandle}:
 *
 * <ul>
 *   <li>{@code max_speed}: metres per second over ground, the speed of a GoTo is limited to this;
 *       0.1 to 100, default 10; can be set while it runs
 *   <li>{@code max_height}: metres above the take-off position; 1 to 10 000, default 120; can be
 *       set while it runs
 *   <li>{@code rate}: states per second, 0.2 to 50, default 5; can be set while it runs
 *   <li>{@code geoid_separation}: local height of the geoid above the ellipsoid, metres, −120 to
 *       100; {@code autopilot}, the default, uses the autopilot's reported value; can be set while
 *       it runs
 *   <li>read-only: {@code current_geoid_separation}, {@code last_command}, {@code last_failure},
 *       {@code last_text}
 * </ul>
 *
 * <p>The module is INITIALIZING until the vehicle's heartbeat and position have been received, and
 * again when no heartbeat has been received for 3 s. A vehicle that has lost its position still
 * executes commands: it can be landed.
 *
 * <p>Tests: {@code link}, {@code identification}, {@code readings} (its position arrives), {@code
 * position} (its position and its height above the ellipsoid are known). Recovery: {@code
 * reopen_link}.
 *
 * <p>Preconditions: the limits of typical small multicopters; see also the manufacturers' manuals.
 */
public final class MavlinkFlightImpl extends EffectorImpl<FlightCommand> implements FlightEffector {

  private static final List<Precondition> PRECONDITIONS =
      List.of(
          new Precondition("wind", 0, 12, "m/s"),
          new Precondition("temperature of the air", -10, 40, "°C"));

  private static final List<String> TAKES =
      List.of("Arm", "Disarm", "GoTo", "Hold", "Land", "ReturnHome", "TakeOff");

  private static final Duration LONGEST_AGE = Duration.ofSeconds(3);

  private final Ticker ticker;
  private final VehicleState vehicleState = new VehicleState();
  private final FlightCommandSequencer sequencer = new FlightCommandSequencer(this::ended);
  private final CommandFailureLog refusals;
  private final FlightLimits limits;
  private final LossOfCommandFailsafe failsafe;
  private final MavlinkLinkHandle port;

  private volatile String awaits = "it has not been started";
  private @Nullable FlightState publishedState; // confined to the reader

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public MavlinkFlightImpl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /** For tests: uses the given clock and source of links. */
  MavlinkFlightImpl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    super(
        context,
        "flight controller, by MAVLink 2",
        "DFRA",
        "1.0",
        TAKES,
        List.of("FlightState"),
        PRECONDITIONS);
    this.ticker = ticker;
    this.refusals = new CommandFailureLog(path(), ticker);
    this.limits = new FlightLimits(path(), settings(), parameterTable(), vehicleState);
    this.failsafe = new LossOfCommandFailsafe(vehicleState, sequencer, ticker);
    this.port = new MavlinkLinkHandle(new Member(), context, ticker, source);
    port.declareIn(diagnostics(), parameterTable());
    String position = "GLOBAL_POSITION_INT";
    diagnostics().addTest("readings", port.arrivalCheck(position, position, () -> LONGEST_AGE));
    diagnostics().addTest("position", this::position);
    parameterTable()
        .declareReadOnly("last_command", "the result of the last command", sequencer::status);
    parameterTable()
        .declareReadOnly("last_failure", "the last command that failed, and why", refusals::last);
    parameterTable().declareReadOnly("last_text", "the autopilot's last warning", refusals::text);
  }

  @Override
  protected void onStart() {
    awaits = "its link is being opened";
    port.start();
  }

  @Override
  protected void onClose() {
    port.close();
    awaits = "it has ended";
    vehicleState.forget();
  }

  @Override
  protected void execute(FlightCommand command) {
    @Nullable MavlinkConnection connection = port.sharedLink();
    @Nullable Vehicle vehicle = connection == null ? null : connection.vehicle();
    if (connection == null || vehicle == null) {
      throw new NotReadyException(path(), readiness(), "its vehicle was lost just now");
    }
    if (!FlightProcedures.supports(vehicle)) {
      throw new IllegalArgumentException(
          path()
              + " has found "
              + vehicle
              + ", but supports only PX4 and ArduPilot; connect one of them");
    }
    MavlinkMessage.@Nullable GlobalPosition here = vehicleState.position(ticker.nanos());
    limits.check(command, here);
    List<MavlinkCommand> steps =
        FlightProcedures.steps(
            command, vehicle, here, vehicleState.separation(), limits.maxSpeed());
    if (command instanceof Arm || command instanceof TakeOff || command instanceof GoTo) {
      haltExecutor().prepare(); // a motion that could not be stopped later is not started
    }
    if (!failsafe.sendCommand(command, steps, connection)) {
      throw new NotReadyException(path(), readiness(), "its vehicle was lost just now");
    }
  }

  @Override
  protected void stopSafely() {
    failsafe.trigger(port.sharedLink());
  }

  /**
   * {@inheritDoc} In the air it holds its position, on the ground it is disarmed, as by {@link
   * LossOfCommandFailsafe}.
   */
  @Override
  protected void stopDuringCommand() {
    failsafe.triggerWithoutLocks(port.sharedLink(), this::isStopDue);
  }

  /** A command has ended; on the reader thread. */
  private void ended(String commandName, MavlinkCommand step, CommandResult result) {
    log.info("{}: {}: {} {}", path(), commandName, step.name(), result);
    failsafe.ended(commandName, result, commander() == null);
    if (readiness() == Readiness.STOPPED) {
      return; // the last command was the stop, and the link outlives this module
    }
    if (!result.isAccepted()) {
      CommandFailedException refusal = refusals.add(commandName, step, result);
      log.warn("{}", refusal.toString());
      recordException(refusal);
    }
    publishState(true);
  }

  /** Publishes the flight state, if it is known; on the reader thread. */
  private void publishState(boolean always) {
    FlightState now = readiness().serves() ? vehicleState.state(ticker.nanos()) : null;
    FlightState last = publishedState;
    if (now != null
        && (always
            || last == null
            || last.phase() != now.phase()
            || last.isArmed() != now.isArmed())) {
      publishedState = now;
      publish(now);
    }
  }

  private DiagnosticFinding position() {
    FlightState now = readiness().serves() ? vehicleState.state(ticker.nanos()) : null;
    if (now == null) {
      return new DiagnosticFinding(false, "it has not reported its flight state: " + awaits);
    }
    return now.position() == null
        ? new DiagnosticFinding(
            false,
            vehicleState.separation() == null
                ? "it does not report its height above the ellipsoid; set geoid_separation"
                : "it has no position; check that its antenna sees the sky")
        : new DiagnosticFinding(true, "it is at " + now.position());
  }

  /** {@inheritDoc} Its time is that of the last message that updated it. */
  @Override
  public FlightState flightState() {
    Readiness readiness = readiness();
    FlightState now = readiness.serves() ? vehicleState.state(ticker.nanos()) : null;
    if (now == null) {
      throw new NotReadyException(path(), readiness, awaits);
    }
    return now;
  }

  @Override
  protected List<? extends Attributes> deviceAttributes() {
    @Nullable MavlinkConnection connection = port.sharedLink();
    @Nullable Vehicle vehicle = connection == null ? null : connection.vehicle();
    @Nullable String version = connection == null ? null : connection.software();
    return List.of(
        new EffectorAttributes(
            TAKES, null, List.of("The air is free of obstacles.", "The wind is below 12 m/s.")),
        new FlightAttributes(
            vehicle == null
                ? null
                : version == null ? vehicle.software() : vehicle.software() + " " + version,
            vehicle == null ? null : vehicle.typeName(),
            limits.maxSpeed(),
            limits.maxHeight()));
  }

  /** Receives the shared link's notifications; on its reader thread. */
  private final class Member implements MavlinkClient {

    @Override
    public String path() {
      return MavlinkFlightImpl.this.path();
    }

    @Override
    public boolean commands() {
      return true;
    }

    @Override
    public Map<Integer, Double> messageRates() {
      double rate = limits.rate();
      return Map.of(
          MessageIds.GLOBAL_POSITION_INT,
          rate,
          MessageIds.VFR_HUD,
          rate,
          MessageIds.EXTENDED_SYS_STATE,
          Math.min(rate, 2),
          MessageIds.GPS_RAW_INT,
          Math.min(rate, 1));
    }

    @Override
    public void vehicleFound(Vehicle vehicle) {
      vehicleState.vehicleFound(vehicle);
      awaits = vehicle + " is connected, but has not reported its position";
    }

    @Override
    public void messageReceived(MavlinkMessage message) {
      if (message instanceof Text text) {
        log.info("{}: the autopilot says: {}", path(), text.text());
        refusals.addStatusText(text);
        return;
      }
      vehicleState.update(message, clock().instant(), ticker.nanos());
      if (readiness() == Readiness.INITIALIZING && vehicleState.isComplete()) {
        transitionTo(Readiness.READY);
      }
      publishState(message instanceof MavlinkMessage.GlobalPosition);
    }

    @Override
    public void periodic() {
      failsafe.retry(port.sharedLink());
    }

    @Override
    public void lost(String reason) {
      awaits = reason;
      if (readiness().serves()) {
        transitionTo(Readiness.INITIALIZING, reason);
      }
      vehicleState.forget();
    }
  }
}
