package org.dfra.sim.device.gps;

import java.time.Duration;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.device.UartLine;

/**
 * Settings of an emulated receiver. Immutable.
 *
 * @param port TCP port on the loopback interface, 0 to 65535; 0 is any free one
 * @param baud bits per second of its output, 1 to 4 000 000
 * @param path trajectory of its antenna
 * @param timeToFirstFix time from its start to the first fix
 * @param options number of channels, and when it learns UTC
 */
public record M12EmulatorSettings(
    int port,
    int baud,
    AntennaTrajectory path,
    Duration timeToFirstFix,
    M12EmulatorSettings.M12EmulatorOptions options) {

  public M12EmulatorSettings {
    if (port < 0 || port > 65535) {
      throw new IllegalArgumentException("port " + port + " is outside 0 to 65535");
    }
    if (baud < 1 || baud > UartLine.FASTEST) {
      throw new IllegalArgumentException(
          "baud rate " + baud + " is outside 1 to " + UartLine.FASTEST);
    }
    if (timeToFirstFix.isNegative()) {
      throw new IllegalArgumentException("time to first fix " + timeToFirstFix + " is negative");
    }
  }

  /**
   * At a fixed position, on any free port, at 9600 baud, with satellites in sight from the start.
   */
  public static M12EmulatorSettings at(GeoPosition position) {
    return new M12EmulatorSettings(
        0, 9600, AntennaTrajectory.fixed(position), Duration.ZERO, M12EmulatorOptions.USUAL);
  }

  /** The same on another port. */
  public M12EmulatorSettings withPort(int other) {
    return new M12EmulatorSettings(other, baud, path, timeToFirstFix, options);
  }

  /** The same with another baud rate. */
  public M12EmulatorSettings withBaud(int other) {
    return new M12EmulatorSettings(port, other, path, timeToFirstFix, options);
  }

  /** The same with another antenna trajectory. */
  public M12EmulatorSettings withPath(AntennaTrajectory other) {
    return new M12EmulatorSettings(port, baud, other, timeToFirstFix, options);
  }

  /** The same with another time to its first fix. */
  public M12EmulatorSettings withTimeToFirstFix(Duration other) {
    return new M12EmulatorSettings(port, baud, path, other, options);
  }

  /** The same with other options. */
  public M12EmulatorSettings withOptions(M12EmulatorOptions other) {
    return new M12EmulatorSettings(port, baud, path, timeToFirstFix, other);
  }

  /**
   * Model of an emulated Oncore, and its initial knowledge of UTC. Immutable.
   *
   * @param channels 8 or 12; one of eight ignores {@code @@Ha}, {@code @@Hb}, {@code @@Hn} and
   *     {@code @@Gd}
   * @param timeToUtc time from its start until it knows the offset of GPS time from UTC: a receiver
   *     without an almanac learns it within 12.5 minutes. Until then {@code @@Bo} is 0, and what it
   *     reports as UTC is GPS time
   */
  record M12EmulatorOptions(int channels, Duration timeToUtc) {

    /** Twelve channels, and a stored almanac. */
    public static final M12EmulatorOptions USUAL = new M12EmulatorOptions(12, Duration.ZERO);

    public M12EmulatorOptions {
      if (channels != 8 && channels != 12) {
        throw new IllegalArgumentException(
            channels + " channels are not supported; an Oncore has 8 or 12");
      }
      if (timeToUtc.isNegative()) {
        throw new IllegalArgumentException("time to UTC " + timeToUtc + " is negative");
      }
    }
  }
}
