package org.dfra.drivers.uav.mavlink;

import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * What a vehicle said, in SI units. Null is what it does not know, or did not tell. Source:
 * mavlink.io, message definitions of the common dialect.
 */
public sealed interface MavlinkMessage {

  /** The message's name, as in its definition: {@code GPS_RAW_INT}. */
  String name();

  /**
   * {@code HEARTBEAT}: it lives.
   *
   * @param type sort of craft, {@code MAV_TYPE}
   * @param autopilot sort of autopilot, {@code MAV_AUTOPILOT}; 8 is none, but a camera or so
   * @param isArmed whether the motors may turn
   * @param mode what it does, in the autopilot's own numbers
   * @param status {@code MAV_STATE}: 3 stands by, 4 flies, 5 and 6 are in trouble
   */
  record Heartbeat(int type, int autopilot, boolean isArmed, long mode, int status)
      implements MavlinkMessage {

    @Override
    public String name() {
      return "HEARTBEAT";
    }
  }

  /**
   * {@code SYS_STATUS}: what feeds it.
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
   * @param boot since it was switched on
   */
  record SystemTime(@Nullable Instant utc, Duration boot) implements MavlinkMessage {

    @Override
    public String name() {
      return "SYSTEM_TIME";
    }
  }

  /**
   * {@code GPS_RAW_INT}: what its satellite receiver says.
   *
   * @param time since the autopilot was switched on, or since 1970: autopilots differ
   * @param fixType {@code GPS_FIX_TYPE}: 0 none there, 1 no fix, 2 2-D, 3 3-D, 4 differential, 5
   *     and 6 real time kinematic, 7 static, 8 precise point positioning
   * @param latitude degrees, north is +
   * @param longitude degrees, east is +
   * @param heightMsl above mean sea level, metres
   * @param height above the WGS84 ellipsoid, metres; MAVLink 1 and old autopilots do not tell it
   * @param horizontalDilution HDOP
   * @param verticalDilution VDOP
   * @param speed over ground, metres per second
   * @param course direction of travel, degrees, 0 to less than 360, 0 is true north, clockwise is +
   * @param satellites that it works with
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
   * {@code GLOBAL_POSITION_INT}: where the autopilot takes itself to be, by all its sensors.
   *
   * @param boot since it was switched on
   * @param latitude degrees, north is +
   * @param longitude degrees, east is +
   * @param heightMsl above mean sea level, metres
   * @param heightAboveHome above where it took off, metres
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
   * {@code VFR_HUD}: how it moves.
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
   * {@code EXTENDED_SYS_STATE}: whether it flies.
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
   * {@code COMMAND_ACK}: what became of a command.
   *
   * @param command {@code MAV_CMD}
   * @param result {@code MAV_RESULT}
   * @param targetSystem whose command it was; 0 where it does not tell
   * @param targetComponent which part of it; 0 where it does not tell
   */
  record CommandAck(int command, int result, int targetSystem, int targetComponent)
      implements MavlinkMessage {

    @Override
    public String name() {
      return "COMMAND_ACK";
    }
  }

  /**
   * {@code BATTERY_STATUS}: one of its batteries.
   *
   * @param id which one, 0 is the first
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
   * {@code AUTOPILOT_VERSION}: what it is.
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
   * {@code STATUSTEXT}: something for people.
   *
   * @param severity 0 emergency to 7 debugging; 4 is a warning
   * @param text what it says
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
   * @param name of its class
   */
  record Other(String name) implements MavlinkMessage {}

  /**
   * An intact message whose content cannot be.
   *
   * @param name the message's name
   * @param reason which value, what it is and what it may be
   */
  record Malformed(String name, String reason) implements MavlinkMessage {}
}
