package org.dfra.drivers.uav.mavlink;

import io.dronefleet.mavlink.common.MavCmd;

/**
 * A command of the command protocol. Unused parameters are 0, or {@link Float#NaN} where the
 * definition uses it for "unchanged".
 */
sealed interface MavlinkCommand {

  /** The command's ID. */
  MavCmd id();

  /** {@code NAV_LAND}. */
  default String name() {
    return id().name().substring("MAV_CMD_".length());
  }

  /** {@code COMMAND_LONG}: seven numbers, with a confirmation counter for retransmissions. */
  record CommandLong(
      MavCmd id, float p1, float p2, float p3, float p4, float p5, float p6, float p7)
      implements MavlinkCommand {

    /** Makes a command with two parameters; the others are 0. */
    static CommandLong of(MavCmd id, double p1, double p2) {
      return new CommandLong(id, (float) p1, (float) p2, 0, 0, 0, 0, 0);
    }
  }

  /**
   * {@code COMMAND_INT}: a command with a position, exact to a centimetre.
   *
   * @param latitude ten-millionths of a degree, north is +
   * @param longitude ten-millionths of a degree, east is +
   * @param heightMsl above mean sea level, metres
   */
  record CommandInt(
      MavCmd id,
      float p1,
      float p2,
      float p3,
      float p4,
      int latitude,
      int longitude,
      float heightMsl)
      implements MavlinkCommand {}
}
