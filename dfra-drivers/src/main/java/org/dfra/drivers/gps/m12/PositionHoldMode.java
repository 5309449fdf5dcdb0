package org.dfra.drivers.gps.m12;

/**
 * {@code @@At}: whether an eight-channel receiver holds its position; also its acknowledgement of
 * the command.
 *
 * @param mode the mode
 */
public record PositionHoldMode(Mode mode) implements M12Message {

  /** The modes of an eight-channel receiver, in the order of the protocol's numbers. */
  public enum Mode {
    /** It solves for its position. */
    OFF,
    /** It holds its position and solves for time only. */
    ON,
    /** It averages its position and holds the result when it has finished. */
    SURVEY
  }

  @Override
  public String id() {
    return "At";
  }
}
