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
import org.dfra.drivers.uav.mavlink.MavlinkMessage.Malformed;
import org.jspecify.annotations.Nullable;

/**
 * Decodes intact frames, one at a time: the library takes the fields out of the payload, which may
 * be shorter or longer than it knows them; here they get their units, and what cannot be makes a
 * {@link Malformed}. Pure; never throws on what a frame says.
 */
public final class MavlinkDecoder {

  private static final MavlinkPayloadDeserializer FIELDS = new ReflectionPayloadDeserializer();

  /** What a field of 16 bits is when its value is not known. */
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

  private static MavlinkMessage of(Heartbeat told) {
    return new MavlinkMessage.Heartbeat(
        told.type().value(),
        told.autopilot().value(),
        (told.baseMode().value() & ARMED) != 0,
        told.customMode(),
        told.systemStatus().value());
  }

  private static MavlinkMessage of(SysStatus told) {
    int remaining = told.batteryRemaining();
    if (remaining < -1 || remaining > 100) {
      return new Malformed("SYS_STATUS", "charge " + remaining + " % is outside 0 to 100 %");
    }
    return new MavlinkMessage.SystemStatus(
        known(told.voltageBattery(), UNKNOWN_16, 1e-3),
        known(told.currentBattery(), -1, 1e-2),
        known(remaining, -1, 1e-2));
  }

  private static MavlinkMessage of(SystemTime told) {
    Duration utc = micros(told.timeUnixUsec());
    return new MavlinkMessage.SystemTime(
        isSince1970(utc) ? Instant.EPOCH.plus(utc) : null, Duration.ofMillis(told.timeBootMs()));
  }

  private static MavlinkMessage of(GpsRawInt told) {
    String fault = fault(told.lat(), told.lon());
    int course = told.cog();
    if (fault == null && course != UNKNOWN_16 && course > 36_000) {
      fault = "course " + course + " is above 36000 hundredths of a degree";
    }
    if (fault != null) {
      return new Malformed("GPS_RAW_INT", fault);
    }
    int height = told.altEllipsoid();
    return new MavlinkMessage.GpsRaw(
        micros(told.timeUsec()),
        told.fixType().value(),
        told.lat() / 1e7,
        told.lon() / 1e7,
        told.alt() / 1e3,
        height == 0 ? null : height / 1e3, // left out at the payload's end
        known(told.eph(), UNKNOWN_16, 1e-2),
        known(told.epv(), UNKNOWN_16, 1e-2),
        known(told.vel(), UNKNOWN_16, 1e-2),
        course == UNKNOWN_16 ? null : course % 36_000 / 1e2,
        told.satellitesVisible() == UNKNOWN_8 ? null : told.satellitesVisible(),
        told.hAcc() == 0 ? null : told.hAcc() / 1e3,
        told.vAcc() == 0 ? null : told.vAcc() / 1e3);
  }

  private static MavlinkMessage of(GlobalPositionInt told) {
    String fault = fault(told.lat(), told.lon());
    int heading = told.hdg();
    if (fault == null && heading != UNKNOWN_16 && heading > 36_000) {
      fault = "heading " + heading + " is above 36000 hundredths of a degree";
    }
    if (fault != null) {
      return new Malformed("GLOBAL_POSITION_INT", fault);
    }
    return new MavlinkMessage.GlobalPosition(
        Duration.ofMillis(told.timeBootMs()),
        told.lat() / 1e7,
        told.lon() / 1e7,
        told.alt() / 1e3,
        told.relativeAlt() / 1e3,
        told.vx() / 1e2,
        told.vy() / 1e2,
        told.vz() / 1e2,
        heading == UNKNOWN_16 ? null : heading % 36_000 / 1e2);
  }

  private static MavlinkMessage of(VfrHud told) {
    float speed = told.groundspeed();
    if (!(speed >= 0 && Float.isFinite(speed + told.alt() + told.climb()))) {
      return new Malformed(
          "VFR_HUD",
          "speed "
              + speed
              + " m/s, height "
              + told.alt()
              + " m, climb "
              + told.climb()
              + " m/s are not all finite, the first of them ≥ 0");
    }
    return new MavlinkMessage.Motion(
        speed, Math.floorMod(told.heading(), 360), told.alt(), told.climb());
  }

  private static MavlinkMessage of(CommandAck told) {
    return new MavlinkMessage.CommandAck(
        told.command().value(), told.result().value(), told.targetSystem(), told.targetComponent());
  }

  private static MavlinkMessage of(BatteryStatus told) {
    int remaining = told.batteryRemaining();
    if (remaining < -1 || remaining > 100) {
      return new Malformed("BATTERY_STATUS", "charge " + remaining + " % is outside 0 to 100 %");
    }
    int known = 0;
    int millivolts = 0;
    for (List<Integer> cells : List.of(told.voltages(), told.voltagesExt())) {
      for (int cell : cells) {
        if (cell != UNKNOWN_16 && cell != 0) {
          known++;
          millivolts += cell;
        }
      }
    }
    return new MavlinkMessage.BatteryStatus(
        told.id(),
        known == 0 ? null : millivolts / 1e3,
        known(told.currentBattery(), -1, 1e-2),
        known(remaining, -1, 1e-2));
  }

  /** The version stands in the upper three bytes, the sort of release in the lowest. */
  private static MavlinkMessage of(AutopilotVersion told) {
    long version = told.flightSwVersion();
    return new MavlinkMessage.Version(
        (version >> 24 & 0xFF) + "." + (version >> 16 & 0xFF) + "." + (version >> 8 & 0xFF));
  }

  private static MavlinkMessage of(Statustext told) {
    return new MavlinkMessage.Text(told.severity().value(), told.text().strip());
  }

  private static @Nullable String fault(int latitude, int longitude) {
    if (Math.abs(latitude / 1e7) > 90) {
      return "latitude " + latitude / 1e7 + "° is outside −90° to 90°";
    }
    return Math.abs(longitude / 1e7) > 180
        ? "longitude " + longitude / 1e7 + "° is outside −180° to 180°"
        : null;
  }

  /** Boot times are shorter than this by decades. */
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
