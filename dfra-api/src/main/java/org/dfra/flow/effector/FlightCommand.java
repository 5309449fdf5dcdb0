package org.dfra.flow.effector;

import org.dfra.geometry.GeoPosition;

/** The commands of a {@link FlightEffector}. */
public sealed interface FlightCommand extends Command {

  /** Starts the motors, on the ground. */
  record Arm() implements FlightCommand {}

  /** Stops the motors, on the ground only. */
  record Disarm() implements FlightCommand {}

  /**
   * Takes off from the ground, armed.
   *
   * @param height metres above the take-off position, above 0
   */
  record TakeOff(double height) implements FlightCommand {

    public TakeOff {
      if (!(height > 0 && Double.isFinite(height))) {
        throw new IllegalArgumentException("take-off height " + height + " m is not > 0");
      }
    }
  }

  /**
   * Flies straight to a position and holds it.
   *
   * @param position the position, frame WGS84, height above the ellipsoid
   * @param speed over ground, metres per second, above 0; limited to the vehicle's maximum
   */
  record GoTo(GeoPosition position, double speed) implements FlightCommand {

    public GoTo {
      if (!(speed > 0 && Double.isFinite(speed))) {
        throw new IllegalArgumentException("flight speed " + speed + " m/s is not > 0");
      }
    }
  }

  /** Holds the current position in the air. */
  record Hold() implements FlightCommand {}

  /** Lands at the current position and stops the motors. */
  record Land() implements FlightCommand {}

  /** Flies back to the take-off position and lands there. */
  record ReturnToLaunch() implements FlightCommand {}
}
