package org.dfra.drivers.pantilt.ptu;

import java.nio.charset.StandardCharsets;
import java.util.List;

/** Commands in the unit's format: upper-case letters, a number, a blank as the end. */
final class PtuCommands {

  /** Disables the echo of commands. */
  public static final String NO_ECHO = "ED";

  /** Sets terse answers: only numbers. */
  public static final String TERSE = "FT";

  /** Executes position commands immediately, not with an await command. */
  public static final String IMMEDIATELY = "I";

  /** Stops both axes. */
  public static final String HALT = "H";

  /** Moves both axes to their end stops and to 0; the reply follows when that is done. */
  public static final String RESET = "R";

  /** Queries the firmware's version. */
  public static final String VERSION = "V";

  private static final String DELIMITER = " ";

  private PtuCommands() {}

  /** Queries the position of an axis. */
  public static String position(PtuAxis axis) {
    return axis.letter() + "P";
  }

  /** Moves both axes to these positions, at these speeds in positions per second. */
  public static List<String> point(int pan, int tilt, int panSpeed, int tiltSpeed) {
    return List.of("PS" + panSpeed, "TS" + tiltSpeed, "PP" + pan, "TP" + tilt);
  }

  /** Commands as bytes, one after the other. */
  public static byte[] bytes(List<String> commands) {
    return (String.join(DELIMITER, commands) + DELIMITER).getBytes(StandardCharsets.US_ASCII);
  }

  /** One of the two axes. */
  enum PtuAxis {
    /** About the vertical; to the left is +. */
    PAN('P'),
    /** About the horizontal, after pan; up is +. */
    TILT('T');

    private final char envelope;

    PtuAxis(char envelope) {
      this.envelope = envelope;
    }

    /** The first letter of its commands. */
    public char letter() {
      return envelope;
    }

    /** {@code pan} or {@code tilt}. */
    @Override
    public String toString() {
      return this == PAN ? "pan" : "tilt";
    }
  }
}
