package org.dfra.drivers.gps.m12;

import org.dfra.core.config.Parameters;
import org.dfra.drivers.gps.m12.M12Message.PositionControl.Mode;

/**
 * The required settings of the receiver, except its rate. Safe for use by several threads.
 *
 * <p>Parameters:
 *
 * <ul>
 *   <li>{@code positioning}: {@code position_3d} (default), {@code altitude_hold}, {@code hold} or
 *       {@code survey}; a receiver that holds its position reports a wrong one on a moving robot
 *   <li>{@code position_message}: {@code full} ({@code @@Ha}, with satellites; default) or {@code
 *       short} ({@code @@Hb}), for a slow line
 * </ul>
 */
final class M12ReceiverSettings {

  private final boolean shortPositions;
  private volatile Mode positioning;

  private M12ReceiverSettings(boolean shortPositions, Mode positioning) {
    this.shortPositions = shortPositions;
    this.positioning = positioning;
  }

  static M12ReceiverSettings from(Parameters parameters) {
    Mode mode = Mode.POSITION_3D;
    if (parameters.find("positioning").isPresent()) {
      try {
        mode = modeOf(parameters.text("positioning"));
      } catch (IllegalArgumentException e) {
        throw parameters.fault("positioning", String.valueOf(e.getMessage()), e);
      }
    }
    String positions =
        parameters.find("position_message").isPresent()
            ? parameters.text("position_message")
            : "full";
    if (!positions.equals("full") && !positions.equals("short")) {
      throw parameters.fault("position_message", "full or short", null);
    }
    return new M12ReceiverSettings(positions.equals("short"), mode);
  }

  /** Whether to use {@code @@Hb} instead of {@code @@Ha}. */
  boolean shortPositions() {
    return shortPositions;
  }

  /** What to solve for. */
  Mode positioning() {
    return positioning;
  }

  /**
   * Sets what to solve for.
   *
   * @throws IllegalArgumentException if the word is invalid; the message explains why
   */
  void setPositioning(String word) {
    positioning = modeOf(word);
  }

  private static Mode modeOf(String word) {
    for (Mode mode : Mode.values()) {
      if (mode.word().equals(word)) {
        return mode;
      }
    }
    throw new IllegalArgumentException("position_3d, altitude_hold, hold or survey");
  }
}
