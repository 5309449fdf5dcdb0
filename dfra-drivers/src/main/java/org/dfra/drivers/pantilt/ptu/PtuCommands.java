package org.dfra.drivers.pantilt.ptu;

import java.nio.charset.StandardCharsets;
import java.util.List;

/** Commands as the unit reads them: upper case letters, a number, a blank to end them. */
public final class PtuCommands {

  /** No echo of commands. */
  public static final String NO_ECHO = "ED";

  /** Numbers alone in the answers. */
  public static final String TERSE = "FT";

  /** Positions are gone to at once, not when they are awaited. */
  public static final String IMMEDIATELY = "I";

  /** Both axes stop where they are. */
  public static final String HALT = "H";

  /** Both axes go to their ends and to 0; the reply comes when that is done. */
  public static final String RESET = "R";

  /** What the firmware is. */
  public static final String VERSION = "V";

  private static final String DELIMITER = " ";

  private PtuCommands() {}

  /** Where an axis is, as a question. */
  public static String position(PtuAxis axis) {
    return axis.letter() + "P";
  }

  /** Both axes go to these positions, each at so many positions per second. */
  public static List<String> point(int pan, int tilt, int panSpeed, int tiltSpeed) {
    return List.of("PS" + panSpeed, "TS" + tiltSpeed, "PP" + pan, "TP" + tilt);
  }

  /** Commands as bytes, one after the other. */
  public static byte[] bytes(List<String> commands) {
    return (String.join(DELIMITER, commands) + DELIMITER).getBytes(StandardCharsets.US_ASCII);
  }
}
