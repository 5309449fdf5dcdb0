package org.dfra.flow.effector;

/** The commands of a {@link DriveEffector}. */
public sealed interface DriveCommand extends Command {

  /**
   * Sets the velocity, from now on and for no longer than {@link
   * DriveEffector#MAX_COMMAND_TIMEOUT}. A velocity above the drive's limits is scaled down, speed
   * and yaw rate alike, so that the curvature stays.
   *
   * @param speed along x of the robot's base, metres per second, forward is +
   * @param yawRate about z, radians per second, to the left is +
   */
  record Velocity(double speed, double yawRate) implements DriveCommand {

    /** Stop. */
    public static final Velocity ZERO = new Velocity(0, 0);

    public Velocity {
      if (!Double.isFinite(speed) || !Double.isFinite(yawRate)) {
        throw new IllegalArgumentException(
            "velocity " + speed + " m/s, " + yawRate + " rad/s is not finite");
      }
    }

    /** Whether both components are zero. */
    public boolean isZero() {
      return speed == 0 && yawRate == 0;
    }

    /** The same curvature, within these limits. */
    public Velocity limitedTo(double maxSpeed, double maxYawRate) {
      double excess = Math.max(Math.abs(speed) / maxSpeed, Math.abs(yawRate) / maxYawRate);
      return excess <= 1 ? this : new Velocity(speed / excess, yawRate / excess);
    }
  }

  /**
   * Sets or releases the parking brake. A velocity other than zero is refused by a {@link
   * BrakeEngagedException} while it is set.
   *
   * @param engaged whether to set it
   */
  record Brake(boolean engaged) implements DriveCommand {}
}
