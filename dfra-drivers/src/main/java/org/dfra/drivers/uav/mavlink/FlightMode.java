package org.dfra.drivers.uav.mavlink;

import io.dronefleet.mavlink.common.MavCmd;

/**
 * Flight modes of an autopilot, with its own numbers. Source: the flight modes of ArduCopter
 * ({@code COPTER_MODE}) and the main and sub modes of PX4.
 */
enum FlightMode {
  /** Holds its position, without a pilot: BRAKE, AUTO.LOITER. */
  HOLD(17, 4, 3),
  /** Flies to commanded positions: GUIDED; PX4 does so in its hold mode. */
  GUIDED(4, 4, 3),
  /** Flies back and lands: RTL, AUTO.RTL. */
  RETURN(6, 4, 5),
  /** Lands: LAND, AUTO.LAND. */
  LAND(9, 4, 6);

  /** Base mode: the custom mode is the autopilot's own. */
  private static final int CUSTOM = 1;

  private final int arduPilot;
  private final int main;
  private final int sub;

  FlightMode(int arduPilot, int main, int sub) {
    this.arduPilot = arduPilot;
    this.main = main;
    this.sub = sub;
  }

  /** The command that sets it. */
  MavlinkCommand set(Vehicle vehicle) {
    return vehicle.autopilot() == Vehicle.ARDUPILOT
        ? MavlinkCommand.CommandLong.of(MavCmd.MAV_CMD_DO_SET_MODE, CUSTOM, arduPilot)
        : new MavlinkCommand.CommandLong(MavCmd.MAV_CMD_DO_SET_MODE, CUSTOM, main, sub, 0, 0, 0, 0);
  }

  /** Whether a heartbeat with this mode reports it. */
  boolean isReportedBy(Vehicle vehicle, long mode) {
    return mode
        == (vehicle.autopilot() == Vehicle.ARDUPILOT
            ? arduPilot
            : (long) sub << 24 | (long) main << 16);
  }
}
