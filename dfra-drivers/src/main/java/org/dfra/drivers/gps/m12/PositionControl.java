package org.dfra.drivers.gps.m12;

import java.util.Locale;

/**
 * {@code @@Gd}: what the receiver solves for; also its acknowledgement of the command.
 *
 * @param mode what it solves for
 */
public record PositionControl(Mode mode) implements M12Message {

  /** What a receiver can solve for, in the order of the protocol's numbers. */
  public enum Mode {
    /** Latitude, longitude and height. The only one for a receiver that moves. */
    POSITION_3D,
    /** Time only; the position is held. */
    HOLD,
    /** Latitude and longitude; the height is held. */
    ALTITUDE_HOLD,
    /** Position, averaged for hours and then held. */
    SURVEY;

    /** The word used in configuration: {@code position_3d}. */
    public String word() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  @Override
  public String id() {
    return "Gd";
  }
}
