package org.dfra.drivers.uav.mavlink;

/**
 * A vehicle from which heartbeats have been received.
 *
 * @param system its number, 1 to 255
 * @param component the number of its autopilot, usually 1
 * @param type type of craft, {@code MAV_TYPE}
 * @param autopilot type of autopilot, {@code MAV_AUTOPILOT}
 */
record Vehicle(int system, int component, int type, int autopilot) {

  static final int ARDUPILOT = 3;
  static final int PX4 = 12;

  /** {@code MAV_AUTOPILOT_INVALID}: a ground station, a camera, a gimbal. */
  static final int NO_AUTOPILOT = 8;

  /** The name of its autopilot software. */
  String software() {
    return switch (autopilot) {
      case ARDUPILOT -> "ArduPilot";
      case PX4 -> "PX4";
      default -> "autopilot " + autopilot;
    };
  }

  /** Human-readable type of craft. */
  String typeName() {
    return switch (type) {
      case 1 -> "fixed wing";
      case 2 -> "quadrotor";
      case 3 -> "coaxial helicopter";
      case 4 -> "helicopter";
      case 13 -> "hexarotor";
      case 14 -> "octorotor";
      case 15 -> "tricopter";
      case 19, 20, 21, 22, 23, 24, 25 -> "vertical take-off and landing";
      default -> "craft " + type;
    };
  }

  @Override
  public String toString() {
    return software() + " " + typeName() + ", vehicle " + system;
  }
}
