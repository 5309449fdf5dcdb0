package org.dfra.flow.sensor;

import java.io.Serial;
import java.time.Instant;
import java.util.OptionalDouble;
import org.dfra.event.Reading;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;

/**
 * One solution of a satellite positioning receiver.
 *
 * @param mode what the receiver solved for
 * @param position the receiver's antenna, frame WGS84; null if and only if the mode is {@link
 *     Mode#NONE}
 * @param utc time of the solution, UTC; the host's time of arrival while the receiver does not know
 *     UTC
 * @param speed speed over ground in metres per second, not negative; NaN while the receiver does
 *     not report it
 * @param course direction of travel in degrees, 0 to 360, 0 is true north, clockwise is +; noise
 *     when {@code speed} is near zero; NaN while the receiver does not report it
 * @param dilutionOfPrecision dilution of precision, without unit: PDOP for a 3-D fix, HDOP for a
 *     2-D one
 * @param satellitesVisible satellites above the horizon by the almanac; may exceed the channels
 * @param satellitesTracked satellites the receiver has locked on
 */
public record GpsFix(
    Mode mode,
    @Nullable GeoPosition position,
    Instant utc,
    double speed,
    double course,
    double dilutionOfPrecision,
    int satellitesVisible,
    int satellitesTracked)
    implements Reading {

  /** What the receiver solved for. */
  public enum Mode {
    /** No position. */
    NONE,
    /** Latitude and longitude; the height is held or old. */
    FIX_2D,
    /** Latitude, longitude and height. */
    FIX_3D,
    /** The position is held and only time is solved for. */
    POSITION_HOLD
  }

  public GpsFix {
    if ((mode == Mode.NONE) != (position == null)) {
      throw new IllegalArgumentException(
          "a fix of mode " + mode + (position == null ? " without" : " with") + " a position");
    }
    if (speed < 0) {
      throw new IllegalArgumentException("speed " + speed + " m/s is not ≥ 0");
    }
    if (course < 0 || course > 360) {
      throw new IllegalArgumentException("course " + course + "° is outside 0° to 360°");
    }
  }

  @Override
  public Instant measured() {
    return utc;
  }

  /** The same solution at another time, UTC. */
  public GpsFix withTime(Instant other) {
    return copy(position, other);
  }

  /** The same solution with another position, frame WGS84. */
  public GpsFix withPosition(GeoPosition other) {
    return copy(other, utc);
  }

  private GpsFix copy(@Nullable GeoPosition at, Instant when) {
    return new GpsFix(
        mode, at, when, speed, course, dilutionOfPrecision, satellitesVisible, satellitesTracked);
  }

  /** Height above the WGS84 ellipsoid in metres, where there is a position. */
  public OptionalDouble height() {
    return position == null ? OptionalDouble.empty() : OptionalDouble.of(position.height());
  }

  @Serial
  private Object writeReplace() {
    return SensorForm.of(this);
  }
}
