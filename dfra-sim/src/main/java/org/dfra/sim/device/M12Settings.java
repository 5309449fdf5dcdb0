package org.dfra.sim.device;

import java.time.Duration;
import org.dfra.geometry.GeoPosition;

/**
 * How an emulated receiver is set up. Immutable.
 *
 * @param port TCP port on the loopback interface, 0 to 65535; 0 is any free one
 * @param baud bits per second at which bytes come out, 1 to 4 000 000
 * @param path where its antenna is
 * @param timeToFirstFix how long after it was started it looks for satellites
 * @param options how many channels it has, and when it learns UTC
 */
public record M12Settings(
    int port, int baud, AntennaPath path, Duration timeToFirstFix, M12Options options) {

  public M12Settings {
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

  /** At a fixed place, on any free port, at 9600 baud, with satellites in sight from the start. */
  public static M12Settings at(GeoPosition position) {
    return new M12Settings(0, 9600, AntennaPath.fixed(position), Duration.ZERO, M12Options.USUAL);
  }

  /** The same on another port. */
  public M12Settings withPort(int other) {
    return new M12Settings(other, baud, path, timeToFirstFix, options);
  }

  /** The same on a line of another speed. */
  public M12Settings withBaud(int other) {
    return new M12Settings(port, other, path, timeToFirstFix, options);
  }

  /** The same on another path. */
  public M12Settings withPath(AntennaPath other) {
    return new M12Settings(port, baud, other, timeToFirstFix, options);
  }

  /** The same with another time to its first fix. */
  public M12Settings withTimeToFirstFix(Duration other) {
    return new M12Settings(port, baud, path, other, options);
  }

  /** The same, of another kind. */
  public M12Settings withOptions(M12Options other) {
    return new M12Settings(port, baud, path, timeToFirstFix, other);
  }
}
