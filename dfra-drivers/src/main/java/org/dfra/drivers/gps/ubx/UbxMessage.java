package org.dfra.drivers.gps.ubx;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** A message from a receiver, decoded from one intact frame. */
public sealed interface UbxMessage {

  /** The message's name, as in the receiver's description: {@code NAV-PVT}. */
  String name();

  /**
   * {@code NAV-PVT}: position, velocity and time.
   *
   * @param utc the time, UTC; null while the receiver does not know date and time
   * @param resolved whether UTC is confirmed, to the second
   * @param fixType 0 none, 1 dead reckoning, 2 2-D, 3 3-D, 4 satellites and dead reckoning, 5 time
   *     only
   * @param fixOk whether the fix is within the receiver's limits, and its position is valid
   * @param satellites satellites used
   * @param latitude degrees, north is +
   * @param longitude degrees, east is +
   * @param height above the ellipsoid, metres
   * @param heightMsl above mean sea level, metres
   * @param horizontalAccuracy estimate, metres, one sigma
   * @param verticalAccuracy estimate, metres, one sigma
   * @param north velocity, metres per second
   * @param east velocity, metres per second
   * @param down velocity, metres per second
   * @param groundSpeed speed over ground, metres per second
   * @param course direction of travel, degrees, 0 to 360, 0 is true north, clockwise is +
   * @param pdop dilution of precision of the position
   */
  record NavPvt(
      @Nullable Instant utc,
      boolean resolved,
      int fixType,
      boolean fixOk,
      int satellites,
      double latitude,
      double longitude,
      double height,
      double heightMsl,
      double horizontalAccuracy,
      double verticalAccuracy,
      double north,
      double east,
      double down,
      double groundSpeed,
      double course,
      double pdop)
      implements UbxMessage {

    @Override
    public String name() {
      return "NAV-PVT";
    }
  }

  /**
   * {@code NAV-SAT}: the satellites.
   *
   * @param satellites all that the receiver knows to be in view
   */
  record NavSat(List<Satellite> satellites) implements UbxMessage {

    public NavSat {
      satellites = List.copyOf(satellites);
    }

    @Override
    public String name() {
      return "NAV-SAT";
    }
  }

  /**
   * A satellite.
   *
   * @param system 0 GPS, 1 augmentation, 2 Galileo, 3 BeiDou, 5 QZSS, 6 GLONASS, 7 NavIC
   * @param number its number in its system
   * @param signal carrier to noise density, dB-Hz; 0 if it is not tracked
   * @param elevation above the horizon, degrees, −90 to 90; out of this range if unknown
   * @param azimuth from true north, clockwise, degrees, 0 to 360
   * @param used whether it is used for the position
   */
  record Satellite(int system, int number, int signal, int elevation, int azimuth, boolean used) {}

  /**
   * {@code ACK-ACK} and {@code ACK-NAK}: the response to a setting.
   *
   * @param accepted whether it was accepted
   * @param type class and ID of the setting, the class in the high byte
   */
  record Ack(boolean accepted, int type) implements UbxMessage {

    @Override
    public String name() {
      return accepted ? "ACK-ACK" : "ACK-NAK";
    }
  }

  /**
   * {@code MON-VER}: the receiver's identification.
   *
   * @param software version of its software
   * @param hardware version of its hardware
   * @param extensions further lines, such as {@code MOD=NEO-M8N}
   */
  record Version(String software, String hardware, List<String> extensions) implements UbxMessage {

    public Version {
      extensions = List.copyOf(extensions);
    }

    @Override
    public String name() {
      return "MON-VER";
    }

    /** The value of {@code key=} in the extensions; null where it is missing. */
    public @Nullable String extension(String key) {
      for (String line : extensions) {
        if (line.startsWith(key + "=")) {
          return line.substring(key.length() + 1);
        }
      }
      return null;
    }
  }

  /**
   * An intact message of another kind.
   *
   * @param type class and ID, the class in the high byte
   */
  record Other(int type) implements UbxMessage {

    @Override
    public String name() {
      return String.format("%04X", type);
    }
  }

  /**
   * An intact message with invalid content.
   *
   * @param name the message's name
   * @param reason which value, what it is, and which values are valid
   */
  record Malformed(String name, String reason) implements UbxMessage {}
}
