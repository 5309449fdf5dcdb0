package org.dfra.drivers.uav.mavlink;

import io.dronefleet.mavlink.common.MavCmd;
import java.util.List;
import org.dfra.drivers.uav.mavlink.MavlinkCommand.CommandInt;
import org.dfra.drivers.uav.mavlink.MavlinkCommand.CommandLong;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.GlobalPosition;
import org.dfra.drivers.uav.mavlink.VehicleState.FlightMode;
import org.dfra.flow.effector.FlightCommand;
import org.dfra.flow.effector.FlightCommand.Arm;
import org.dfra.flow.effector.FlightCommand.Disarm;
import org.dfra.flow.effector.FlightCommand.GoTo;
import org.dfra.flow.effector.FlightCommand.Hold;
import org.dfra.flow.effector.FlightCommand.Land;
import org.dfra.flow.effector.FlightCommand.TakeOff;
import org.jspecify.annotations.Nullable;

/**
 * The steps of each flight command for each autopilot; each step waits for the acknowledgement of
 * the previous one. Pure.
 *
 * <pre>
 *               PX4                            ArduPilot
 *   Arm         hold, arm                      guided, arm
 *   TakeOff     take off to a height MSL       guided, take off to a height above here
 *   GoTo        reposition at a speed          guided, reposition, change speed
 *   Hold        hold (AUTO.LOITER)             hold (BRAKE; its LOITER follows a pilot's stick,
 *                                              and descends where there is none)
 *   Land        land                           land
 *   ReturnHome  return to launch               return to launch
 *   Disarm      disarm, never by force         the same
 * </pre>
 */
final class FlightProcedures {

  private static final float AS_IT_IS = Float.NaN;

  /** For {@code DO_REPOSITION}: fly there, whatever the current mode. */
  private static final float CHANGE_MODE = 1;

  /** For {@code DO_CHANGE_SPEED}: over ground. */
  private static final float GROUND_SPEED = 1;

  private FlightProcedures() {}

  /** Whether commands to such a vehicle are supported. */
  static boolean supports(Vehicle vehicle) {
    return vehicle.autopilot() == Vehicle.PX4 || vehicle.autopilot() == Vehicle.ARDUPILOT;
  }

  /**
   * The steps of a command.
   *
   * @param position the vehicle's position; null if unknown
   * @param separation height of the geoid above the ellipsoid, metres; null if unknown
   * @param maxSpeed maximum speed, metres per second
   * @throws IllegalArgumentException if an unknown value is needed; the message names it
   */
  static List<MavlinkCommand> steps(
      FlightCommand command,
      Vehicle vehicle,
      @Nullable GlobalPosition position,
      @Nullable Double separation,
      double maxSpeed) {
    boolean arduPilot = vehicle.autopilot() == Vehicle.ARDUPILOT;
    if (command instanceof Arm) {
      FlightMode mode = arduPilot ? FlightMode.GUIDED : FlightMode.HOLD;
      return List.of(mode.set(vehicle), armed(true));
    } else if (command instanceof Disarm) {
      return List.of(armed(false));
    } else if (command instanceof TakeOff requested) {
      return takeOff(requested, vehicle, position);
    } else if (command instanceof GoTo requested) {
      return goTo(requested, vehicle, separation, Math.min(requested.speed(), maxSpeed));
    } else if (command instanceof Hold) {
      return List.of(FlightMode.HOLD.set(vehicle));
    } else if (command instanceof Land) {
      return List.of(here(MavCmd.MAV_CMD_NAV_LAND, arduPilot, 0));
    }
    return List.of(CommandLong.of(MavCmd.MAV_CMD_NAV_RETURN_TO_LAUNCH, 0, 0));
  }

  private static MavlinkCommand armed(boolean armed) {
    return CommandLong.of(MavCmd.MAV_CMD_COMPONENT_ARM_DISARM, armed ? 1 : 0, 0);
  }

  private static List<MavlinkCommand> takeOff(
      TakeOff requested, Vehicle vehicle, @Nullable GlobalPosition here) {
    if (vehicle.autopilot() == Vehicle.ARDUPILOT) {
      return List.of(
          FlightMode.GUIDED.set(vehicle),
          here(MavCmd.MAV_CMD_NAV_TAKEOFF, true, (float) requested.height()));
    }
    if (here == null) {
      throw new IllegalArgumentException(
          vehicle
              + " has no position, so the height of its take-off cannot be computed; wait for its"
              + " satellite fix");
    }
    return List.of(
        here(MavCmd.MAV_CMD_NAV_TAKEOFF, false, (float) (here.heightMsl() + requested.height())));
  }

  /**
   * A command at the current position: PX4 accepts NaN for it, as the protocol defines; ArduPilot
   * ignores the position but converts its numbers to integers first.
   */
  private static MavlinkCommand here(MavCmd id, boolean arduPilot, float height) {
    float place = arduPilot ? 0 : AS_IT_IS;
    return new CommandLong(id, 0, 0, 0, place, place, place, height);
  }

  private static List<MavlinkCommand> goTo(
      GoTo requested, Vehicle vehicle, @Nullable Double separation, double speed) {
    if (separation == null) {
      throw new IllegalArgumentException(
          vehicle
              + " has not reported its height above the ellipsoid, so no height can be commanded;"
              + " set the parameter geoid_separation");
    }
    CommandInt there =
        new CommandInt(
            MavCmd.MAV_CMD_DO_REPOSITION,
            (float) speed,
            CHANGE_MODE,
            0,
            AS_IT_IS,
            (int) Math.round(requested.position().latitude() * 1e7),
            (int) Math.round(requested.position().longitude() * 1e7),
            (float) (requested.position().height() - separation));
    return vehicle.autopilot() == Vehicle.ARDUPILOT
        ? List.of(
            FlightMode.GUIDED.set(vehicle),
            there,
            CommandLong.of(MavCmd.MAV_CMD_DO_CHANGE_SPEED, GROUND_SPEED, speed))
        : List.of(there);
  }
}
