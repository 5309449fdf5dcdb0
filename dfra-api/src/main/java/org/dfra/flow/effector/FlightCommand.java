package org.dfra.flow.effector;

import org.dfra.geometry.GeoPosition;

/** What a {@link FlightEffector} can be told. */
public sealed interface FlightCommand extends Command {

  /** Start the motors, on the ground. */
  record Arm() implements FlightCommand {}

  /** Stop the motors, on the ground only. */
  record Disarm() implements FlightCommand {}

  /**
   * Rise from where it stands, armed.
   *
   * @param height metres above the place it rises from, above 0
   */
  record TakeOff(double height) implements FlightCommand {

    public TakeOff {
      if (!(height > 0 && Double.isFinite(height))) {
        throw new IllegalArgumentException("take-off height " + height + " m is not > 0");
      }
    }
  }

  /**
   * Fly straight to there and stay.
   *
   * @param position where to, frame WGS84, height above the ellipsoid
   * @param speed over ground, metres per second, above 0; what is faster than it can is made slower
   */
  record GoTo(GeoPosition position, double speed) implements FlightCommand {

    public GoTo {
      if (!(speed > 0 && Double.isFinite(speed))) {
        throw new IllegalArgumentException("flight speed " + speed + " m/s is not > 0");
      }
    }
  }

  /** Stay in the air where it is now. */
  record Hold() implements FlightCommand {}

  /** Go down to the ground where it is now and stop the motors. */
  record Land() implements FlightCommand {}

  /** Fly back to where it took off and land there. */
  record ReturnToLaunch() implements FlightCommand {}
}
