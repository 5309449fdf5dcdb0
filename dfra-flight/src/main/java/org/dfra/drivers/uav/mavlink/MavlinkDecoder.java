package org.dfra.drivers.uav.mavlink;

import io.dronefleet.mavlink.common.AutopilotVersion;
import io.dronefleet.mavlink.common.BatteryStatus;
import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.ExtendedSysState;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.GpsRawInt;
import io.dronefleet.mavlink.common.Statustext;
import io.dronefleet.mavlink.common.SysStatus;
import io.dronefleet.mavlink.common.SystemTime;
import io.dronefleet.mavlink.common.VfrHud;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.serialization.payload.MavlinkPayloadDeserializer;
import io.dronefleet.mavlink.serialization.payload.reflection.ReflectionPayloadDeserializer;
import java.math.BigInteger;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import org.dfra.drivers.uav.mavlink.MavlinkCatalogue.MessageIds;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.Malformed;
import org.dfra.drivers.uav.mavlink.MavlinkParser.MavlinkFrame;
import org.dfra.drivers.uav.mavlink.MavlinkParser.MavlinkFramer;
import org.jspecify.annotations.Nullable;

/**
 * Decodes intact frames, one at a time: the library extracts the fields from the payload, which may
 * be shorter or longer than its definition; this class converts their units, and an invalid value
 * makes a {@link Malformed}. Pure; never throws, whatever the content of a frame.
 */
final class MavlinkDecoder {

  private static final MavlinkPayloadDeserializer FIELDS = new ReflectionPayloadDeserializer();

  /** Value of a 16-bit field that is unknown. */
  private static final int UNKNOWN_16 = 65_535;

  private static final int UNKNOWN_8 = 255;

  /** Flag of the base mode. */
  private static final int ARMED = 0x80;

  private MavlinkDecoder() {}

  /**
   * Decodes a frame found by {@link MavlinkFramer}.
   *
   * @param bytes holds it
   * @param offset index of its first byte
   * @param length its length in bytes
   */
  public static MavlinkFrame decode(byte[] bytes, int offset, int length) {
    boolean second = bytes[offset] == MavlinkFramer.MARK_2;
    int head = second ? MavlinkFramer.HEAD_2 : MavlinkFramer.HEAD_1;
    int from = offset + head;
    byte[] payload = Arrays.copyOfRange(bytes, from, from + (bytes[offset + 1] & 0xFF));
    int sender = offset + (second ? 4 : 2);
    int id = second ? MavlinkFramer.message(bytes, offset) : bytes[offset + 5] & 0xFF;
    return new MavlinkFrame(
        second ? 2 : 1,
        bytes[sender + 1] & 0xFF,
        bytes[sender + 2] & 0xFF,
        bytes[sender] & 0xFF,
        message(id, payload));
  }

  private static MavlinkMessage message(int id, byte[] payload) {
    return switch (id) {
      case MessageIds.HEARTBEAT -> of(FIELDS.deserialize(payload, Heartbeat.class));
      case MessageIds.SYS_STATUS -> of(FIELDS.deserialize(payload, SysStatus.class));
      case MessageIds.SYSTEM_TIME -> of(FIELDS.deserialize(payload, SystemTime.class));
      case MessageIds.GPS_RAW_INT -> of(FIELDS.deserialize(payload, GpsRawInt.class));
      case MessageIds.GLOBAL_POSITION_INT ->
          of(FIELDS.deserialize(payload, GlobalPositionInt.class));
      case MessageIds.VFR_HUD -> of(FIELDS.deserialize(payload, VfrHud.class));
      case MessageIds.COMMAND_ACK -> of(FIELDS.deserialize(payload, CommandAck.class));
      case MessageIds.BATTERY_STATUS -> of(FIELDS.deserialize(payload, BatteryStatus.class));
      case MessageIds.AUTOPILOT_VERSION -> of(FIELDS.deserialize(payload, AutopilotVersion.class));
      case MessageIds.EXTENDED_SYS_STATE ->
          new MavlinkMessage.ExtendedState(
              FIELDS.deserialize(payload, ExtendedSysState.class).landedState().value());
      case MessageIds.STATUSTEXT -> of(FIELDS.deserialize(payload, Statustext.class));
      default -> new MavlinkMessage.Other(MavlinkCatalogue.name(id));
    };
  }

  private static MavlinkMessage of(Heartbeat reported) {
    return new MavlinkMessage.Heartbeat(
        reported.type().value(),
        reported.autopilot().value(),
        (reported.baseMode().value() & ARMED) != 0,
        reported.customMode(),
        reported.systemStatus().value());
  }

  private static MavlinkMessage of(SysStatus reported) {
    int remaining = reported.batteryRemaining();
    if (remaining < -1 || remaining > 100) {
      return new Malformed("SYS_STATUS", "charge " + remaining + " % is outside 0 to 100 %");
    }
    return new MavlinkMessage.SystemStatus(
        known(reported.voltageBattery(), UNKNOWN_16, 1e-3),
        known(reported.currentBattery(), -1, 1e-2),
        known(remaining, -1, 1e-2));
  }

  private static MavlinkMessage of(SystemTime reported) {
    Duration utc = micros(reported.timeUnixUsec());
    return new MavlinkMessage.SystemTime(
        isSince1970(utc) ? Instant.EPOCH.plus(utc) : null,
        Duration.ofMillis(reported.timeBootMs()));
  }

  private static MavlinkMessage of(GpsRawInt reported) {
    String fault = fault(reported.lat(), reported.lon());
    int course = reported.cog();
    if (fault == null && course != UNKNOWN_16 && course > 36_000) {
      fault = "course " + course + " is above 36000 hundredths of a degree";
    }
    if (fault != null) {
      return new Malformed("GPS_RAW_INT", fault);
    }
    int height = reported.altEllipsoid();
    return new MavlinkMessage.GpsRaw(
        micros(reported.timeUsec()),
        reported.fixType().value(),
        reported.lat() / 1e7,
        reported.lon() / 1e7,
        reported.alt() / 1e3,
        height == 0 ? null : height / 1e3, // omitted at the payload's end
        known(reported.eph(), UNKNOWN_16, 1e-2),
        known(reported.epv(), UNKNOWN_16, 1e-2),
        known(reported.vel(), UNKNOWN_16, 1e-2),
        course == UNKNOWN_16 ? null : course % 36_000 / 1e2,
        reported.satellitesVisible() == UNKNOWN_8 ? null : reported.satellitesVisible(),
        reported.hAcc() == 0 ? null : reported.hAcc() / 1e3,
        reported.vAcc() == 0 ? null : reported.vAcc() / 1e3);
  }

  private static MavlinkMessage of(GlobalPositionInt reported) {
    String fault = fault(reported.lat(), reported.lon());
    int heading = reported.hdg();
    if (fault == null && heading != UNKNOWN_16 && heading > 36_000) {
      fault = "heading " + heading + " is above 36000 hundredths of a degree";
    }
    if (fault != null) {
      return new Malformed("GLOBAL_POSITION_INT", fault);
    }
    return new MavlinkMessage.GlobalPosition(
        Duration.ofMillis(reported.timeBootMs()),
        reported.lat() / 1e7,
        reported.lon() / 1e7,
        reported.alt() / 1e3,
        reported.relativeAlt() / 1e3,
        reported.vx() / 1e2,
        reported.vy() / 1e2,
        reported.vz() / 1e2,
        heading == UNKNOWN_16 ? null : heading % 36_000 / 1e2);
  }

  private static MavlinkMessage of(VfrHud reported) {
    float speed = reported.groundspeed();
    if (!(speed >= 0 && Float.isFinite(speed + reported.alt() + reported.climb()))) {
      return new Malformed(
          "VFR_HUD",
          "speed "
              + speed
              + " m/s, height "
              + reported.alt()
              + " m, climb "
              + reported.climb()
              + " m/s must be finite, and the speed ≥ 0");
    }
    return new MavlinkMessage.VfrHud(
        speed, Math.floorMod(reported.heading(), 360), reported.alt(), reported.climb());
  }

  private static MavlinkMessage of(CommandAck reported) {
    return new MavlinkMessage.CommandAck(
        reported.command().value(),
        reported.result().value(),
        reported.targetSystem(),
        reported.targetComponent());
  }

  private static MavlinkMessage of(BatteryStatus reported) {
    int remaining = reported.batteryRemaining();
    if (remaining < -1 || remaining > 100) {
      return new Malformed("BATTERY_STATUS", "charge " + remaining + " % is outside 0 to 100 %");
    }
    int known = 0;
    int millivolts = 0;
    for (List<Integer> cells : List.of(reported.voltages(), reported.voltagesExt())) {
      for (int cell : cells) {
        if (cell != UNKNOWN_16 && cell != 0) {
          known++;
          millivolts += cell;
        }
      }
    }
    return new MavlinkMessage.BatteryStatus(
        reported.id(),
        known == 0 ? null : millivolts / 1e3,
        known(reported.currentBattery(), -1, 1e-2),
        known(remaining, -1, 1e-2));
  }

  /** The upper three bytes are the version, the lowest is the release type. */
  private static MavlinkMessage of(AutopilotVersion reported) {
    long version = reported.flightSwVersion();
    return new MavlinkMessage.Version(
        (version >> 24 & 0xFF) + "." + (version >> 16 & 0xFF) + "." + (version >> 8 & 0xFF));
  }

  private static MavlinkMessage of(Statustext reported) {
    return new MavlinkMessage.Text(reported.severity().value(), reported.text().strip());
  }

  private static @Nullable String fault(int latitude, int longitude) {
    if (Math.abs(latitude / 1e7) > 90) {
      return "latitude " + latitude / 1e7 + "° is outside −90° to 90°";
    }
    return Math.abs(longitude / 1e7) > 180
        ? "longitude " + longitude / 1e7 + "° is outside −180° to 180°"
        : null;
  }

  /** Whether a time counts from 1970; times since boot are shorter by decades. */
  static boolean isSince1970(Duration time) {
    return time.toDays() > 10_000;
  }

  private static @Nullable Double known(int value, int unknown, double unit) {
    return value == unknown ? null : Math.round(value * unit * 1e6) / 1e6;
  }

  private static Duration micros(BigInteger unsigned) {
    long micros = unsigned.bitLength() > 62 ? Long.MAX_VALUE / 2 : unsigned.longValue();
    return Duration.ofSeconds(micros / 1_000_000, micros % 1_000_000 * 1000);
  }
}
