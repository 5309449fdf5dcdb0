package org.dfra.drivers.uav.mavlink;

import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * A message from a vehicle, in SI units. Unknown and unreported values are null. Source:
 * mavlink.io, message definitions of the common dialect.
 */
sealed interface MavlinkMessage {

  /** The message's name, as in its definition: {@code GPS_RAW_INT}. */
  String name();

  /**
   * {@code HEARTBEAT}: it is alive.
   *
   * @param type type of craft, {@code MAV_TYPE}
   * @param autopilot type of autopilot, {@code MAV_AUTOPILOT}; 8 is none, for example a camera
   * @param isArmed whether the motors may turn
   * @param mode its flight mode, in the autopilot's own numbers
   * @param status {@code MAV_STATE}: 3 standby, 4 active, 5 critical, 6 emergency
   */
  record Heartbeat(int type, int autopilot, boolean isArmed, long mode, int status)
      implements MavlinkMessage {

    @Override
    public String name() {
      return "HEARTBEAT";
    }
  }

  /**
   * {@code SYS_STATUS}: its power supply.
   *
   * @param voltage volts
   * @param current drawn, amperes
   * @param remaining charge left, 0 to 1
   */
  record SystemStatus(
      @Nullable Double voltage, @Nullable Double current, @Nullable Double remaining)
      implements MavlinkMessage {

    @Override
    public String name() {
      return "SYS_STATUS";
    }
  }

  /**
   * {@code SYSTEM_TIME}: its clock.
   *
   * @param utc the time, UTC
   * @param boot time since it was switched on
   */
  record SystemTime(@Nullable Instant utc, Duration boot) implements MavlinkMessage {

    @Override
    public String name() {
      return "SYSTEM_TIME";
    }
  }

  /**
   * {@code GPS_RAW_INT}: the data of its satellite receiver.
   *
   * @param time since the autopilot was switched on, or since 1970: autopilots differ
   * @param fixType {@code GPS_FIX_TYPE}: 0 no receiver, 1 no fix, 2 2-D, 3 3-D, 4 differential, 5
   *     and 6 real time kinematic, 7 static, 8 precise point positioning
   * @param latitude degrees, north is +
   * @param longitude degrees, east is +
   * @param heightMsl above mean sea level, metres
   * @param height above the WGS84 ellipsoid, metres; MAVLink 1 and old autopilots do not report it
   * @param horizontalDilution HDOP
   * @param verticalDilution VDOP
   * @param speed over ground, metres per second
   * @param course direction of travel, degrees, 0 to less than 360, 0 is true north, clockwise is +
   * @param satellites number of satellites used
   * @param horizontalAccuracy estimate, metres, one sigma
   * @param verticalAccuracy estimate, metres, one sigma
   */
  record GpsRaw(
      Duration time,
      int fixType,
      double latitude,
      double longitude,
      double heightMsl,
      @Nullable Double height,
      @Nullable Double horizontalDilution,
      @Nullable Double verticalDilution,
      @Nullable Double speed,
      @Nullable Double course,
      @Nullable Integer satellites,
      @Nullable Double horizontalAccuracy,
      @Nullable Double verticalAccuracy)
      implements MavlinkMessage {

    @Override
    public String name() {
      return "GPS_RAW_INT";
    }
  }

  /**
   * {@code GLOBAL_POSITION_INT}: the autopilot's position estimate from all its sensors.
   *
   * @param boot time since it was switched on
   * @param latitude degrees, north is +
   * @param longitude degrees, east is +
   * @param heightMsl above mean sea level, metres
   * @param heightAboveHome above the take-off position, metres
   * @param north velocity, metres per second
   * @param east velocity, metres per second
   * @param down velocity, metres per second, down is +
   * @param heading of its nose, degrees, 0 to less than 360, 0 is true north, clockwise is +
   */
  record GlobalPosition(
      Duration boot,
      double latitude,
      double longitude,
      double heightMsl,
      double heightAboveHome,
      double north,
      double east,
      double down,
      @Nullable Double heading)
      implements MavlinkMessage {

    @Override
    public String name() {
      return "GLOBAL_POSITION_INT";
    }
  }

  /**
   * {@code VFR_HUD}: its motion.
   *
   * @param speed over ground, metres per second, not negative
   * @param heading of its nose, degrees, 0 to less than 360, 0 is true north, clockwise is +
   * @param heightMsl above mean sea level, metres
   * @param climb metres per second, up is +
   */
  record VfrHud(double speed, double heading, double heightMsl, double climb)
      implements MavlinkMessage {

    @Override
    public String name() {
      return "VFR_HUD";
    }
  }

  /**
   * {@code EXTENDED_SYS_STATE}: whether it is flying.
   *
   * @param landed {@code MAV_LANDED_STATE}: 0 not known, 1 on the ground, 2 in the air, 3 taking
   *     off, 4 landing
   */
  record ExtendedState(int landed) implements MavlinkMessage {

    @Override
    public String name() {
      return "EXTENDED_SYS_STATE";
    }
  }

  /**
   * {@code COMMAND_ACK}: the result of a command.
   *
   * @param command {@code MAV_CMD}
   * @param result {@code MAV_RESULT}
   * @param targetSystem system that sent the command; 0 if not reported
   * @param targetComponent component that sent it; 0 if not reported
   */
  record CommandAck(int command, int result, int targetSystem, int targetComponent)
      implements MavlinkMessage {

    @Override
    public String name() {
      return "COMMAND_ACK";
    }
  }

  /**
   * {@code BATTERY_STATUS}: the state of a battery.
   *
   * @param id its number, 0 is the first
   * @param voltage volts
   * @param current drawn, amperes; negative while it is charged
   * @param remaining charge left, 0 to 1
   */
  record BatteryStatus(
      int id, @Nullable Double voltage, @Nullable Double current, @Nullable Double remaining)
      implements MavlinkMessage {

    @Override
    public String name() {
      return "BATTERY_STATUS";
    }
  }

  /**
   * {@code AUTOPILOT_VERSION}: its version.
   *
   * @param software version of its software: {@code 1.14.3}
   */
  record Version(String software) implements MavlinkMessage {

    @Override
    public String name() {
      return "AUTOPILOT_VERSION";
    }
  }

  /**
   * {@code STATUSTEXT}: a text for the operator.
   *
   * @param severity 0 emergency to 7 debugging; 4 is a warning
   * @param text the text
   */
  record Text(int severity, String text) implements MavlinkMessage {

    @Override
    public String name() {
      return "STATUSTEXT";
    }
  }

  /**
   * An intact message of another kind.
   *
   * @param name name of its class
   */
  record Other(String name) implements MavlinkMessage {}

  /**
   * An intact message with invalid content.
   *
   * @param name the message's name
   * @param reason which value, what it is, and which values are valid
   */
  record Malformed(String name, String reason) implements MavlinkMessage {}
}
