package org.dfra.drivers.gps.m12;

import java.time.Instant;
import java.util.List;
import org.dfra.flow.sensor.GpsFix;

/** A message with position, time and satellites. */
public sealed interface M12PositionMessage extends M12Message
    permits Position12Channels, ShortPosition, Position8Channels {

  /** Date and time of the solution, in the scale the receiver is set to. */
  M12Time time();

  /** The position: filtered where the receiver filters. Old or zero where the mode is NONE. */
  M12Position position();

  /** Speed over ground, metres per second. */
  double groundSpeed();

  /** Direction of travel, degrees, 0 is true north, clockwise is +. */
  double heading();

  /** Dilution of precision, without unit: PDOP for 3-D, HDOP for 2-D, 0 for a held position. */
  double dilution();

  /** Satellites above the horizon by the almanac; may exceed the channels. */
  int visible();

  /** Satellites locked on. */
  int tracked();

  /** The state of every channel, in the receiver's order. */
  List<SatelliteChannel> channels();

  /** What was solved for. */
  GpsFix.Mode mode();

  /** The receiver's state as human-readable text, for an operator who waits for a position. */
  String stateInWords();

  /**
   * The time as UTC. Where {@link #knowsUtc} is false it may be GPS time, which is ahead of UTC by
   * the leap seconds since 1980 (18 s since 2017).
   */
  Instant utc();

  /** Whether {@link #utc} is confirmed as UTC by this message. */
  boolean knowsUtc();

  /** Converts the message to a fix, from this message alone. */
  default GpsFix toFix() {
    return toFix(mode(), utc());
  }

  /**
   * Converts the message to a fix, with data from other messages.
   *
   * @param mode what was solved for
   * @param utc time of the solution
   */
  default GpsFix toFix(GpsFix.Mode mode, Instant utc) {
    return new GpsFix(
        mode,
        mode == GpsFix.Mode.NONE ? null : position().toGeoPosition(),
        utc,
        groundSpeed(),
        heading(),
        dilution(),
        visible(),
        tracked());
  }
}
