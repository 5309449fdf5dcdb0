package org.dfra.sim.device.uav;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.EnumMap;
import java.util.Map;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.sim.body.BatteryBody;
import org.dfra.sim.body.FlightBody;
import org.dfra.sim.body.FlightBody.Flight;
import org.dfra.sim.device.AntennaPath;
import org.dfra.sim.device.Schedule;
import org.dfra.sim.device.SerialDevice;
import org.dfra.sim.device.UartLine;
import org.jspecify.annotations.Nullable;

/**
 * The autopilot of a quadrotor between its two wires, in MAVLink 2: PX4 or ArduPilot, as far as a
 * ground station sees them.
 *
 * <p>It tells by itself, once a second: {@code HEARTBEAT}, {@code SYS_STATUS}, {@code
 * BATTERY_STATUS}, {@code SYSTEM_TIME}, {@code GPS_RAW_INT}, {@code GLOBAL_POSITION_INT}, {@code
 * VFR_HUD}, {@code EXTENDED_SYS_STATE}; all but the first as often as {@code SET_MESSAGE_INTERVAL}
 * says. Where it is comes from the body, what its receiver says from the antenna. Commands: arm and
 * disarm, take-off, reposition, change of speed, mode, land, return, and {@code REQUEST_MESSAGE} of
 * {@code AUTOPILOT_VERSION}; each is answered. What it does is the pilot's, see the package.
 *
 * <p>Its state outlives a client, as that of a vehicle outlives a radio link.
 */
public final class AutopilotDevice implements SerialDevice {

  /** With more than this waiting the line is too slow for what was asked; something is left out. */
  private static final int LONGEST_QUEUE = 4096;

  private static final Duration USUAL = Duration.ofSeconds(1);
  private static final Duration SHORTEST = Duration.ofMillis(10);

  private static final Wire[] TOLD = {
    Wire.HEARTBEAT,
    Wire.SYS_STATUS,
    Wire.BATTERY_STATUS,
    Wire.SYSTEM_TIME,
    Wire.GPS_RAW_INT,
    Wire.GLOBAL_POSITION_INT,
    Wire.VFR_HUD,
    Wire.EXTENDED_SYS_STATE
  };

  private final AutopilotSettings settings;
  private final FlightBody body;
  private final AntennaPath antenna;
  private final BatteryBody battery;
  private final UartLine line;
  private final Pilot pilot;
  private final Telemetry telemetry;
  private final OrderReader reader;
  private final Map<Wire, Schedule> schedules = new EnumMap<>(Wire.class);
  private @Nullable Instant powerOn;
  private Instant now = Instant.MIN;

  /**
   * @param settings what it is set to
   * @param datum where the body's east, north and up are zero, frame WGS84
   * @param body what it flies
   * @param antenna where its satellite receiver takes itself to be
   * @param battery what feeds it
   */
  public AutopilotDevice(
      AutopilotSettings settings,
      GeoPosition datum,
      FlightBody body,
      AntennaPath antenna,
      BatteryBody battery) {
    LocalFrame world = new LocalFrame(datum);
    this.settings = settings;
    this.body = body;
    this.antenna = antenna;
    this.battery = battery;
    this.line = new UartLine(settings.baud());
    this.pilot = new Pilot(settings, world, body, battery);
    this.telemetry = new Telemetry(settings, world);
    this.reader = new OrderReader(settings.vehicle(), new Station());
  }

  /** {@inheritDoc} What the last one has half said is forgotten, and nothing else. */
  @Override
  public void connected() {
    reader.forget();
  }

  @Override
  public int baud() {
    return line.baud();
  }

  @Override
  public void receive(byte[] bytes, int offset, int length, Instant time) {
    pass(time);
    reader.take(bytes, offset, length);
    sayTexts();
  }

  @Override
  public void transmit(ByteBuffer out, Instant time) {
    pass(time);
    line.take(out, time);
  }

  private void pass(Instant time) {
    now = time;
    if (powerOn == null) {
      powerOn = time;
      for (Wire each : TOLD) {
        Schedule schedule = new Schedule();
        schedule.set(USUAL, time);
        schedules.put(each, schedule);
      }
    }
    pilot.step(time);
    schedules.forEach(
        (message, schedule) -> {
          if (schedule.due(time) != null && line.waitingBytes() <= LONGEST_QUEUE) {
            tell(message);
          }
        });
    sayTexts();
  }

  private Duration boot() {
    return powerOn == null ? Duration.ZERO : Duration.between(powerOn, now);
  }

  private boolean hasFix() {
    return boot().compareTo(settings.timeToFirstFix()) >= 0;
  }

  private void tell(Wire message) {
    Flight flight = body.at(now);
    boolean isSilent =
        message == Wire.GLOBAL_POSITION_INT
            && !hasFix()
            && settings.software() == AutopilotSoftware.PX4;
    if (isSilent) {
      return; // the other tells zeros
    }
    switch (message) {
      case HEARTBEAT -> say(telemetry.heartbeat(pilot, flight));
      case SYS_STATUS -> say(telemetry.systemStatus(battery.at(now)));
      case BATTERY_STATUS -> say(telemetry.battery(battery.at(now)));
      case SYSTEM_TIME -> say(telemetry.time(now, boot(), hasFix()));
      case GPS_RAW_INT -> say(telemetry.receiver(antenna.at(now), now, boot(), hasFix()));
      case GLOBAL_POSITION_INT -> say(telemetry.position(flight, boot(), hasFix()));
      case VFR_HUD -> say(telemetry.motion(flight));
      case EXTENDED_SYS_STATE -> say(telemetry.landed(pilot.landed(flight)));
      case AUTOPILOT_VERSION -> say(telemetry.version());
      case COMMAND_INT, COMMAND_LONG, COMMAND_ACK, STATUSTEXT -> {} // not by itself
    }
  }

  private void say(byte[] frame) {
    line.send(frame, now);
  }

  private void sayTexts() {
    pilot.texts().forEach(text -> say(telemetry.text(text)));
  }

  private int setInterval(Order order) {
    Wire message = Wire.of(order.whole(1));
    Schedule schedule = message == null ? null : schedules.get(message);
    if (schedule == null || message == Wire.HEARTBEAT) {
      return Pilot.DENIED;
    }
    double micros = order.p(2);
    Duration every = micros == 0 ? USUAL : Duration.ofNanos(Math.round(micros * 1e3));
    if (micros < 0) {
      every = Duration.ZERO;
    } else if (every.compareTo(SHORTEST) < 0) {
      return Pilot.DENIED;
    }
    schedule.set(every, now);
    return Pilot.ACCEPTED;
  }

  private int send(Order order) {
    Wire message = Wire.of(order.whole(1));
    if (message != Wire.AUTOPILOT_VERSION && (message == null || !schedules.containsKey(message))) {
      return Pilot.DENIED;
    }
    tell(message);
    return Pilot.ACCEPTED;
  }

  private int obey(Order order) {
    return switch (order.command()) {
      case Order.ARM -> pilot.arm(order.p(1) == 1, hasFix(), now);
      case Order.TAKE_OFF -> pilot.takeOff(order.p(7), now);
      case Order.SET_MODE -> pilot.set(mode(order), hasFix(), now);
      case Order.REPOSITION ->
          pilot.reposition(
              order.p(5), order.p(6), order.p(7), order.p(1), (order.whole(2) & 1) != 0, now);
      case Order.CHANGE_SPEED -> pilot.changeSpeed(order.p(2), now);
      case Order.LAND -> pilot.land(now);
      case Order.RETURN -> pilot.goBack(now);
      case Order.MESSAGE_INTERVAL -> setInterval(order);
      case Order.REQUEST_MESSAGE -> send(order);
      default -> Pilot.UNSUPPORTED;
    };
  }

  private int mode(Order order) {
    return settings.software() == AutopilotSoftware.PX4
        ? order.whole(2) << 16 | order.whole(3) << 24
        : order.whole(2);
  }

  /** Takes what the ground station says. */
  private final class Station implements OrderReader.Listener {

    @Override
    public void heartbeat(int sender) {
      pilot.heartbeat(now);
    }

    @Override
    public void order(Order order) {
      @Nullable Integer whim = settings.whims().answer(order.command(), order.confirmation());
      if (whim == null) {
        say(telemetry.answer(order, obey(order)));
      } else if (whim != AutopilotSettings.Whims.DEAF) {
        say(telemetry.answer(order, whim));
      }
    }
  }
}
