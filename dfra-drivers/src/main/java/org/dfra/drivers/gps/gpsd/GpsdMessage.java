package org.dfra.drivers.gps.gpsd;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** A message from gpsd, decoded from one line. A number that is not reported is NaN or −1. */
public sealed interface GpsdMessage {

  /** The object's class: {@code TPV}. */
  String name();

  /**
   * {@code TPV}: time, position, velocity.
   *
   * @param device which receiver; empty if not reported
   * @param mode 0 unknown, 1 no fix, 2 2-D, 3 3-D
   * @param status 0 unknown, 1 normal, 2 differential, 3 and 4 real time kinematic, 5 dead
   *     reckoning, 6 satellites and dead reckoning, 7 surveyed, 8 simulated, 9 P(Y)
   * @param time UTC; null if not reported
   * @param latitude degrees, north is +
   * @param longitude degrees, east is +
   * @param height above the ellipsoid, metres
   * @param speed over ground, metres per second
   * @param track direction of travel, degrees, 0 is true north, clockwise is +
   * @param horizontalError estimate, metres; gpsd does not state its confidence level
   * @param verticalError the same for the height
   */
  record Tpv(
      String device,
      int mode,
      int status,
      @Nullable Instant time,
      double latitude,
      double longitude,
      double height,
      double speed,
      double track,
      double horizontalError,
      double verticalError)
      implements GpsdMessage {

    @Override
    public String name() {
      return "TPV";
    }
  }

  /**
   * {@code SKY}: the satellites.
   *
   * @param satellites those in view; null where the object has only dilutions
   * @param pdop dilution of precision of the position
   * @param hdop the same, horizontal
   */
  record Sky(@Nullable List<Satellite> satellites, double pdop, double hdop)
      implements GpsdMessage {

    @Override
    public String name() {
      return "SKY";
    }
  }

  /**
   * A satellite.
   *
   * @param prn gpsd's own number; −1 if not reported
   * @param system 0 GPS, 1 augmentation, 2 Galileo, 3 BeiDou, 5 QZSS, 6 GLONASS, 7 NavIC; −1 if not
   *     reported
   * @param number its number in its system; −1 if not reported
   * @param elevation above the horizon, degrees; NaN if not reported
   * @param azimuth from true north, clockwise, degrees; NaN if not reported
   * @param signal dB-Hz; NaN if not reported
   * @param used whether it is used for the position
   */
  record Satellite(
      int prn,
      int system,
      int number,
      double elevation,
      double azimuth,
      double signal,
      boolean used) {}

  /**
   * {@code VERSION}.
   *
   * @param release gpsd's version
   */
  record Version(String release) implements GpsdMessage {

    @Override
    public String name() {
      return "VERSION";
    }
  }

  /**
   * {@code DEVICE}, alone or in {@code DEVICES}.
   *
   * @param path the receiver's path; empty if not reported
   * @param driver type that gpsd has detected; empty if not known yet
   * @param subtype the receiver's identification; empty if it has sent none
   */
  record Device(String path, String driver, String subtype) implements GpsdMessage {

    @Override
    public String name() {
      return "DEVICE";
    }
  }

  /** {@code DEVICES}: the receivers that gpsd has. */
  record Devices(List<Device> devices) implements GpsdMessage {

    public Devices {
      devices = List.copyOf(devices);
    }

    @Override
    public String name() {
      return "DEVICES";
    }
  }

  /** An object of another class. */
  record Other(String name) implements GpsdMessage {}

  /**
   * A line that is not JSON, or has invalid values.
   *
   * @param name the object's class as far as it could be read
   * @param reason what is wrong
   */
  record Malformed(String name, String reason) implements GpsdMessage {}
}
