package org.dfra.sim.device.uav;

import java.time.Duration;
import java.time.Instant;
import java.util.EnumMap;
import java.util.Map;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.sim.device.Schedule;
import org.dfra.sim.device.UartDevice;
import org.dfra.sim.device.gps.AntennaTrajectory;
import org.dfra.sim.device.uav.AutopilotSettings.AutopilotSoftware;
import org.dfra.sim.device.uav.MavlinkCommandReader.ReceivedCommand;
import org.dfra.sim.device.uav.MavlinkFrameWriter.MavlinkMessageType;
import org.dfra.sim.physics.BatteryPhysics;
import org.dfra.sim.physics.MulticopterPhysics;
import org.dfra.sim.physics.MulticopterPhysics.MulticopterState;
import org.jspecify.annotations.Nullable;

/**
 * Emulates the autopilot of a quadrotor at the byte level, in MAVLink 2: PX4 or ArduPilot, as far
 * as visible to a ground station.
 *
 * <p>It sends unsolicited, once a second: {@code HEARTBEAT}, {@code SYS_STATUS}, {@code
 * BATTERY_STATUS}, {@code SYSTEM_TIME}, {@code GPS_RAW_INT}, {@code GLOBAL_POSITION_INT}, {@code
 * VFR_HUD}, {@code EXTENDED_SYS_STATE}; all but the first as often as {@code SET_MESSAGE_INTERVAL}
 * sets. Its position comes from the body, its receiver's data from the antenna. Commands: arm and
 * disarm, take-off, reposition, change of speed, mode, land, return, and {@code REQUEST_MESSAGE} of
 * {@code AUTOPILOT_VERSION}; each is acknowledged. {@link AutopilotStateMachine} determines its
 * behaviour, see the package.
 *
 * <p>Its state survives a change of client, as a vehicle's state survives loss of the radio link.
 */
public final class AutopilotDevice extends UartDevice {

  /**
   * If more bytes than this are queued, the baud rate is too low for the requested messages;
   * messages are skipped.
   */
  private static final int LONGEST_QUEUE = 4096;

  private static final Duration USUAL = Duration.ofSeconds(1);
  private static final Duration SHORTEST = Duration.ofMillis(10);

  private static final MavlinkMessageType[] STREAMED = {
    MavlinkMessageType.HEARTBEAT,
    MavlinkMessageType.SYS_STATUS,
    MavlinkMessageType.BATTERY_STATUS,
    MavlinkMessageType.SYSTEM_TIME,
    MavlinkMessageType.GPS_RAW_INT,
    MavlinkMessageType.GLOBAL_POSITION_INT,
    MavlinkMessageType.VFR_HUD,
    MavlinkMessageType.EXTENDED_SYS_STATE
  };

  private final AutopilotSettings settings;
  private final MulticopterPhysics body;
  private final AntennaTrajectory antenna;
  private final BatteryPhysics battery;
  private final AutopilotStateMachine pilot;
  private final Telemetry telemetry;
  private final MavlinkCommandReader reader;
  private final Map<MavlinkMessageType, Schedule> schedules =
      new EnumMap<>(MavlinkMessageType.class);
  private @Nullable Instant powerOn;
  private Instant now = Instant.MIN;

  /**
   * @param settings of the autopilot
   * @param datum where the body's east, north and up are zero, frame WGS84
   * @param body of the vehicle
   * @param antenna measured position of its satellite receiver
   * @param battery that powers it
   */
  public AutopilotDevice(
      AutopilotSettings settings,
      GeoPosition datum,
      MulticopterPhysics body,
      AntennaTrajectory antenna,
      BatteryPhysics battery) {
    super(settings.baud());
    LocalFrame world = new LocalFrame(datum);
    this.settings = settings;
    this.body = body;
    this.antenna = antenna;
    this.battery = battery;
    this.pilot = new AutopilotStateMachine(settings, world, body, battery);
    this.telemetry = new Telemetry(settings, world);
    this.reader = new MavlinkCommandReader(settings.vehicle(), new Station());
  }

  /** {@inheritDoc} Discards the last client's incomplete frame, and nothing else. */
  @Override
  public void connected() {
    reader.forget();
  }

  @Override
  public void receive(byte[] bytes, int offset, int length, Instant time) {
    advance(time);
    reader.take(bytes, offset, length);
    sendStatusTexts();
  }

  @Override
  protected void advance(Instant time) {
    now = time;
    if (powerOn == null) {
      powerOn = time;
      for (MavlinkMessageType each : STREAMED) {
        Schedule schedule = new Schedule();
        schedule.set(USUAL, time);
        schedules.put(each, schedule);
      }
    }
    pilot.step(time);
    schedules.forEach(
        (message, schedule) -> {
          if (schedule.due(time) != null && channel().waitingBytes() <= LONGEST_QUEUE) {
            sendMessage(message);
          }
        });
    sendStatusTexts();
  }

  private Duration boot() {
    return powerOn == null ? Duration.ZERO : Duration.between(powerOn, now);
  }

  private boolean hasFix() {
    return boot().compareTo(settings.timeToFirstFix()) >= 0;
  }

  private void sendMessage(MavlinkMessageType message) {
    MulticopterState flight = body.at(now);
    boolean isSilent =
        message == MavlinkMessageType.GLOBAL_POSITION_INT
            && !hasFix()
            && settings.software() == AutopilotSoftware.PX4;
    if (isSilent) {
      return; // the other sends zeros
    }
    switch (message) {
      case HEARTBEAT -> enqueue(telemetry.heartbeat(pilot, flight));
      case SYS_STATUS -> enqueue(telemetry.systemStatus(battery.at(now)));
      case BATTERY_STATUS -> enqueue(telemetry.battery(battery.at(now)));
      case SYSTEM_TIME -> enqueue(telemetry.time(now, boot(), hasFix()));
      case GPS_RAW_INT -> enqueue(telemetry.receiver(antenna.at(now), now, boot(), hasFix()));
      case GLOBAL_POSITION_INT -> enqueue(telemetry.position(flight, boot(), hasFix()));
      case VFR_HUD -> enqueue(telemetry.motion(flight));
      case EXTENDED_SYS_STATE -> enqueue(telemetry.landed(pilot.landed(flight)));
      case AUTOPILOT_VERSION -> enqueue(telemetry.version());
      case COMMAND_INT, COMMAND_LONG, COMMAND_ACK, STATUSTEXT -> {} // not unsolicited
    }
  }

  private void enqueue(byte[] frame) {
    channel().send(frame, now);
  }

  private void sendStatusTexts() {
    pilot.texts().forEach(text -> enqueue(telemetry.text(text)));
  }

  private int setInterval(ReceivedCommand command) {
    MavlinkMessageType message = MavlinkMessageType.of(command.whole(1));
    Schedule schedule = message == null ? null : schedules.get(message);
    if (schedule == null || message == MavlinkMessageType.HEARTBEAT) {
      return AutopilotStateMachine.DENIED;
    }
    double micros = command.parameter(2);
    Duration every = micros == 0 ? USUAL : Duration.ofNanos(Math.round(micros * 1e3));
    if (micros < 0) {
      every = Duration.ZERO;
    } else if (every.compareTo(SHORTEST) < 0) {
      return AutopilotStateMachine.DENIED;
    }
    schedule.set(every, now);
    return AutopilotStateMachine.ACCEPTED;
  }

  private int send(ReceivedCommand command) {
    MavlinkMessageType message = MavlinkMessageType.of(command.whole(1));
    if (message != MavlinkMessageType.AUTOPILOT_VERSION
        && (message == null || !schedules.containsKey(message))) {
      return AutopilotStateMachine.DENIED;
    }
    sendMessage(message);
    return AutopilotStateMachine.ACCEPTED;
  }

  private int execute(ReceivedCommand command) {
    return switch (command.command()) {
      case ReceivedCommand.ARM ->
          command.parameter(1) == 1 ? pilot.arm(hasFix(), now) : pilot.disarm(now);
      case ReceivedCommand.TAKE_OFF -> pilot.takeOff(command.parameter(7), now);
      case ReceivedCommand.SET_MODE -> pilot.set(mode(command), hasFix(), now);
      case ReceivedCommand.REPOSITION ->
          pilot.reposition(
              command.parameter(5),
              command.parameter(6),
              command.parameter(7),
              command.parameter(1),
              (command.whole(2) & 1) != 0,
              now);
      case ReceivedCommand.CHANGE_SPEED -> pilot.changeSpeed(command.parameter(2), now);
      case ReceivedCommand.LAND -> pilot.land(now);
      case ReceivedCommand.RETURN -> pilot.goBack(now);
      case ReceivedCommand.MESSAGE_INTERVAL -> setInterval(command);
      case ReceivedCommand.REQUEST_MESSAGE -> send(command);
      default -> AutopilotStateMachine.UNSUPPORTED;
    };
  }

  private int mode(ReceivedCommand command) {
    return settings.software() == AutopilotSoftware.PX4
        ? command.whole(2) << 16 | command.whole(3) << 24
        : command.whole(2);
  }

  /** Handles the ground station's messages. */
  private final class Station implements MavlinkCommandReader.Listener {

    @Override
    public void heartbeat(int sender) {
      pilot.heartbeat(now);
    }

    @Override
    public void commandReceived(ReceivedCommand command) {
      @Nullable Integer whim =
          settings.commandFaults().answer(command.command(), command.confirmation());
      if (whim == null) {
        enqueue(telemetry.answer(command, execute(command)));
      } else if (whim != AutopilotSettings.CommandFaults.NO_ANSWER) {
        enqueue(telemetry.answer(command, whim));
      }
    }
  }
}
