package org.dfra.drivers.uav.mavlink;

import io.dronefleet.mavlink.common.MavCmd;

/**
 * A command of the command protocol. Parameters that mean nothing are 0, or {@link Float#NaN} where
 * the definition says that this is "as it is now".
 */
sealed interface MavlinkCommand {

  /** Which one. */
  MavCmd id();

  /** {@code NAV_LAND}. */
  default String name() {
    return id().name().substring("MAV_CMD_".length());
  }

  /** {@code COMMAND_LONG}: seven numbers, counted by a confirmation when it is sent again. */
  record CommandLong(
      MavCmd id, float p1, float p2, float p3, float p4, float p5, float p6, float p7)
      implements MavlinkCommand {

    /** With two parameters, the others 0. */
    static CommandLong of(MavCmd id, double p1, double p2) {
      return new CommandLong(id, (float) p1, (float) p2, 0, 0, 0, 0, 0);
    }
  }

  /**
   * {@code COMMAND_INT}: at a place, exact to a centimetre.
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
