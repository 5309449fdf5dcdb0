package org.dfra.sim.device.uav;

/** What flies the vehicle: the two autopilots differ in numbers and in habits. */
public enum AutopilotSoftware {
  /** Takes off to heights above mean sea level; rejects for now what it cannot do yet. */
  PX4(12, 0x010F04FF, 3 << 16, mode(3), mode(3), mode(2), mode(5), mode(6)),
  /** Takes off to heights above home, in the mode GUIDED; what it cannot do yet fails. */
  ARDUPILOT(3, 0x040600FF, 0, 17, 4, 4, 6, 9);

  /** What the pilot in the vehicle may be set to do. */
  enum Mode {
    /** A person flies, or would. */
    MANUAL,
    /** Stays where it is. */
    HOLD,
    /** Flies where it is told. */
    GUIDED,
    /** Rises. */
    TAKE_OFF,
    /** Flies back and lands. */
    RETURN,
    /** Goes down. */
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

  /** Of {@code AUTOPILOT_VERSION}: major, minor, patch, sort of release; a byte each. */
  int version() {
    return version;
  }

  /** The number of a mode in {@code HEARTBEAT}. */
  int number(Mode mode) {
    return modes[mode.ordinal()];
  }
}
