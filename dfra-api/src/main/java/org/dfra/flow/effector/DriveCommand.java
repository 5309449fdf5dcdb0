package org.dfra.flow.effector;

/** What a {@link DriveEffector} can be told. */
public sealed interface DriveCommand extends Command {

  /**
   * Move so, from now on and for no longer than {@link DriveEffector#MAX_COMMAND_TIMEOUT}. What is
   * faster than the drive can is made slower, speed and turn rate alike, so that the curve stays.
   *
   * @param speed along x of the robot's base, metres per second, forward is +
   * @param yawRate about z, radians per second, to the left is +
   */
  record Velocity(double speed, double yawRate) implements DriveCommand {

    /** Stand still. */
    public static final Velocity ZERO = new Velocity(0, 0);

    public Velocity {
      if (!Double.isFinite(speed) || !Double.isFinite(yawRate)) {
        throw new IllegalArgumentException(
            "velocity " + speed + " m/s, " + yawRate + " rad/s is not finite");
      }
    }

    /** Whether it is no motion at all. */
    public boolean isZero() {
      return speed == 0 && yawRate == 0;
    }

    /** The same curve, no faster than that. */
    public Velocity limitedTo(double maxSpeed, double maxYawRate) {
      double excess = Math.max(Math.abs(speed) / maxSpeed, Math.abs(yawRate) / maxYawRate);
      return excess <= 1 ? this : new Velocity(speed / excess, yawRate / excess);
    }
  }

  /**
   * Set or release the parking brake. A velocity other than zero is refused by a {@link
   * BrakeEngagedException} while it is set.
   *
   * @param engaged whether to set it
   */
  record Brake(boolean engaged) implements DriveCommand {}
}
