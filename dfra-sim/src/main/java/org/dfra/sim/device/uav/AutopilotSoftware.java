package org.dfra.sim.device.uav;

/** The vehicle's autopilot software: the two differ in numbers and in behaviour. */
public enum AutopilotSoftware {
  /**
   * Takes off to heights above mean sea level; replies TEMPORARILY_REJECTED to commands that it
   * cannot execute yet.
   */
  PX4(12, 0x010F04FF, 3 << 16, mode(3), mode(3), mode(2), mode(5), mode(6)),
  /**
   * Takes off to heights above home, in the mode GUIDED; replies FAILED to commands that it cannot
   * execute yet.
   */
  ARDUPILOT(3, 0x040600FF, 0, 17, 4, 4, 6, 9);

  /** Flight modes of the vehicle. */
  enum Mode {
    /** Manual control by a human pilot. */
    MANUAL,
    /** Holds its position. */
    HOLD,
    /** Flies to commanded positions. */
    GUIDED,
    /** Takes off. */
    TAKE_OFF,
    /** Returns home and lands. */
    RETURN,
    /** Lands. */
    LAND
  }

  private final int autopilot;
  private final int version;
  private final int[] modes;

  AutopilotSoftware(int autopilot, int version, int... modes) {
    this.autopilot = autopilot;
    this.version = version;
    this.modes = modes;
  }

  /** The number of one of PX4's automatic modes. */
  private static int mode(int sub) {
    return sub << 24 | 4 << 16;
  }

  /** {@code MAV_AUTOPILOT}. */
  int autopilot() {
    return autopilot;
  }

  /** Of {@code AUTOPILOT_VERSION}: major, minor, patch, release type; a byte each. */
  int version() {
    return version;
  }

  /** The number of a mode in {@code HEARTBEAT}. */
  int number(Mode mode) {
    return modes[mode.ordinal()];
  }
}
