package org.dfra.benchmarks.micro;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dfra.drivers.gps.m12.M12Commands;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.device.SerialDevice;
import org.dfra.sim.device.gps.AntennaTrajectory;
import org.dfra.sim.device.gps.M12Device;
import org.dfra.sim.device.gps.NmeaDevice;

/** The bytes that an emulated device sends in {@value #SECONDS} seconds. Always the same. */
public final class DeviceRecording {

  /** Bytes that a driver reads at once. */
  public static final int BUFFER_BYTES = 4096;

  /** Bits per second of the line, fast enough for all messages. */
  public static final int BAUD = 4_000_000;

  private static final Instant BEGIN = Instant.parse("2026-01-21T07:33:29Z");
  private static final int SECONDS = 300;
  private static final int TENTHS = 10; // of a second
  private static final int TENTH_MILLIS = 100;

  /** The receiver's antenna moves at 1 m/s. */
  public static final AntennaTrajectory PATH =
      AntennaTrajectory.constantVelocity(
          new GeoPosition(52.910313611, 6.866706667, 55.91), BEGIN, 0.6, 0.8);

  private DeviceRecording() {}

  /**
   * An M12+ receiver that sends position, time and the state of its satellites once a second, in
   * Motorola's binary protocol.
   */
  public static byte[] m12() {
    return of(
        new M12Device(PATH, BAUD, Duration.ZERO),
        List.of(
            M12Commands.timeRaimOn(),
            M12Commands.positionOf12Channels(1),
            M12Commands.timeRaimOf12Channels(1),
            M12Commands.visibleSatellites(true)));
  }

  /** A receiver that sends the usual sentences of NMEA 0183 once a second. */
  public static byte[] nmea() {
    return of(new NmeaDevice(PATH, BAUD, Duration.ZERO), List.of());
  }

  /**
   * Any device's output.
   *
   * @param commands that it receives first
   */
  public static byte[] of(SerialDevice device, List<byte[]> commands) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    device.connected();
    for (byte[] command : commands) {
      device.receive(command, 0, command.length, BEGIN);
    }
    ByteBuffer out = ByteBuffer.allocate(BUFFER_BYTES);
    for (int tenth = 0; tenth < SECONDS * TENTHS; tenth++) {
      out.clear();
      device.transmit(out, BEGIN.plusMillis((long) TENTH_MILLIS * tenth));
      all.write(out.array(), 0, out.position());
    }
    return all.toByteArray();
  }
}
