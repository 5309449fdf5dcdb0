package org.dfra.sim.device.uav;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.sim.device.gps.AntennaTrajectory.AntennaState;
import org.dfra.sim.device.uav.AutopilotSettings.AutopilotSoftware;
import org.dfra.sim.device.uav.AutopilotSettings.AutopilotSoftware.Mode;
import org.dfra.sim.device.uav.MavlinkCommandReader.ReceivedCommand;
import org.dfra.sim.device.uav.MavlinkFrameWriter.MavlinkMessageType;
import org.dfra.sim.physics.BatteryPhysics.Charge;
import org.dfra.sim.physics.MulticopterPhysics.MulticopterState;

/** Encodes an autopilot's telemetry. Confined to one thread. */
final class Telemetry {

  /** Value of a 16-bit field that is unknown. */
  private static final short UNKNOWN = (short) 0xFFFF;

  private static final int QUADROTOR = 2;
  private static final int PROTOCOL = 3;
  private static final int CUSTOM_MODE = 1;
  private static final int GUIDED = 8;
  private static final int STABILIZED = 16;
  private static final int ARMED = 128;
  private static final int CELLS = 4;
  private static final int SATELLITES = 11;

  private final AutopilotSettings settings;
  private final LocalFrame world;
  private final MavlinkFrameWriter frames;

  Telemetry(AutopilotSettings settings, LocalFrame world) {
    this.settings = settings;
    this.world = world;
    this.frames = new MavlinkFrameWriter(settings.vehicle(), 1);
  }

  byte[] heartbeat(AutopilotStateMachine pilot, MulticopterState flight) {
    Mode mode = pilot.mode();
    int flags = CUSTOM_MODE | STABILIZED | (mode == Mode.MANUAL ? 0 : GUIDED);
    boolean flies = pilot.landed(flight) != 1;
    ByteBuffer out = MavlinkFrameWriter.payload().putInt(settings.software().number(mode));
    out.put((byte) QUADROTOR).put((byte) settings.software().autopilot());
    out.put((byte) (flags | (pilot.isArmed() ? ARMED : 0)));
    out.put((byte) (pilot.isMissingStation() ? 5 : flies ? 4 : 3)).put((byte) PROTOCOL);
    return frames.frame(MavlinkMessageType.HEARTBEAT, out);
  }

  byte[] systemStatus(Charge charge) {
    ByteBuffer out =
        MavlinkFrameWriter.payload().putInt(0).putInt(0).putInt(0).putShort((short) 250);
    out.putShort((short) Math.round(charge.voltage() * 1e3));
    out.putShort((short) Math.round(charge.current() * 1e2));
    out.put(new byte[12]).put((byte) Math.round(charge.remaining() * 100));
    return frames.frame(MavlinkMessageType.SYS_STATUS, out);
  }

  byte[] battery(Charge charge) {
    ByteBuffer out = MavlinkFrameWriter.payload().putInt(-1).putInt(-1).putShort((short) 0x7FFF);
    for (int cell = 0; cell < 10; cell++) {
      out.putShort(cell < CELLS ? (short) Math.round(charge.voltage() * 1e3 / CELLS) : UNKNOWN);
    }
    out.putShort((short) Math.round(charge.current() * 1e2)).put((byte) 0).put((byte) 1);
    out.put((byte) 1).put((byte) Math.round(charge.remaining() * 100));
    return frames.frame(MavlinkMessageType.BATTERY_STATUS, out);
  }

  /** Without the date while it is unknown. */
  byte[] time(Instant time, Duration boot, boolean hasFix) {
    ByteBuffer out = MavlinkFrameWriter.payload().putLong(hasFix ? micros(time) : 0);
    return frames.frame(MavlinkMessageType.SYSTEM_TIME, out.putInt((int) boot.toMillis()));
  }

  /** PX4 sends the time since boot, ArduPilot the time since 1970. */
  byte[] receiver(AntennaState antenna, Instant time, Duration boot, boolean hasFix) {
    boolean px4 = settings.software() == AutopilotSoftware.PX4;
    ByteBuffer out =
        MavlinkFrameWriter.payload().putLong(px4 || !hasFix ? boot.toNanos() / 1000 : micros(time));
    GeoPosition at = antenna.position();
    if (hasFix) {
      out.putInt(degrees(at.latitude())).putInt(degrees(at.longitude()));
      out.putInt((int) Math.round((at.height() - settings.separation()) * 1e3));
      out.putShort((short) 90).putShort((short) 120);
      out.putShort((short) Math.round(antenna.speed() * 1e2));
      out.putShort((short) (Math.round(antenna.course() * 1e2) % 36_000));
      out.put((byte) 3).put((byte) SATELLITES);
      out.putInt((int) Math.round(at.height() * 1e3)).putInt(1500).putInt(2500).putInt(300);
    } else {
      out.putInt(0).putInt(0).putInt(0).putShort(UNKNOWN).putShort(UNKNOWN);
      out.putShort(UNKNOWN).putShort(UNKNOWN).put((byte) 1).put((byte) 3);
    }
    return frames.frame(MavlinkMessageType.GPS_RAW_INT, out);
  }

  byte[] position(MulticopterState flight, Duration boot, boolean hasFix) {
    ByteBuffer out = MavlinkFrameWriter.payload().putInt((int) boot.toMillis());
    GeoPosition at = world.toGeo(new LocalPosition(flight.east(), flight.north(), flight.up()));
    out.putInt(hasFix ? degrees(at.latitude()) : 0).putInt(hasFix ? degrees(at.longitude()) : 0);
    out.putInt(hasFix ? (int) Math.round((at.height() - settings.separation()) * 1e3) : 0);
    out.putInt((int) Math.round(flight.up() * 1e3));
    out.putShort((short) Math.round(flight.northward() * 1e2));
    out.putShort((short) Math.round(flight.eastward() * 1e2));
    out.putShort((short) Math.round(-flight.upward() * 1e2));
    out.putShort((short) (Math.round(heading(flight) * 1e2) % 36_000));
    return frames.frame(MavlinkMessageType.GLOBAL_POSITION_INT, out);
  }

  byte[] motion(MulticopterState flight) {
    double height = world.datum().height() - settings.separation() + flight.up();
    ByteBuffer out = MavlinkFrameWriter.payload().putFloat(0);
    out.putFloat((float) Math.hypot(flight.eastward(), flight.northward()));
    out.putFloat((float) height).putFloat((float) flight.upward());
    out.putShort((short) (Math.round(heading(flight)) % 360));
    out.putShort((short) (flight.rotorsTurning() ? 50 : 0));
    return frames.frame(MavlinkMessageType.VFR_HUD, out);
  }

  byte[] landed(int landed) {
    ByteBuffer out = MavlinkFrameWriter.payload().put((byte) 0).put((byte) landed);
    return frames.frame(MavlinkMessageType.EXTENDED_SYS_STATE, out);
  }

  byte[] version() {
    ByteBuffer out = MavlinkFrameWriter.payload().putLong(0).putLong(0);
    out.putInt(settings.software().version()).put(new byte[40]);
    return frames.frame(MavlinkMessageType.AUTOPILOT_VERSION, out);
  }

  byte[] answer(ReceivedCommand command, int result) {
    ByteBuffer out =
        MavlinkFrameWriter.payload().putShort((short) command.command()).put((byte) result);
    out.put((byte) 0).putInt(0).put((byte) command.sender()).put((byte) command.senderComponent());
    return frames.frame(MavlinkMessageType.COMMAND_ACK, out);
  }

  /** A warning. */
  byte[] text(String text) {
    byte[] envelopes = Arrays.copyOf(text.getBytes(StandardCharsets.US_ASCII), 50);
    return frames.frame(
        MavlinkMessageType.STATUSTEXT, MavlinkFrameWriter.payload().put((byte) 4).put(envelopes));
  }

  /** Heading, degrees from north, clockwise, 0 to less than 360. */
  private static double heading(MulticopterState flight) {
    double degrees = 90 - Math.toDegrees(flight.yaw());
    return ((degrees % 360) + 360) % 360;
  }

  private static int degrees(double angle) {
    return (int) Math.round(angle * 1e7);
  }

  private static long micros(Instant time) {
    return time.getEpochSecond() * 1_000_000 + time.getNano() / 1000;
  }
}
