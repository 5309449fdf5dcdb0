package org.dfra.flow.effector;

/** What a {@link DriveEffector} can be told. */
public sealed interface DriveCommand extends Command {

  /**
   * Move so, from now on and for no longer than {@link DriveEffector#LONGEST_SILENCE}. What is
   * faster than the drive can is made slower, speed and turn rate alike, so that the curve stays.
   *
   * @param speed along x of the robot's base, metres per second, forward is +
   * @param turnRate about z, radians per second, to the left is +
   */
  record Velocity(double speed, double turnRate) implements DriveCommand {

    /** Stand still. */
    public static final Velocity ZERO = new Velocity(0, 0);

    public Velocity {
      if (!Double.isFinite(speed) || !Double.isFinite(turnRate)) {
        throw new IllegalArgumentException(
            "velocity " + speed + " m/s, " + turnRate + " rad/s is not finite");
      }
    }

    /** Whether it is no motion at all. */
    public boolean isZero() {
      return speed == 0 && turnRate == 0;
    }

    /** The same curve, no faster than that. */
    public Velocity within(double mostSpeed, double mostTurnRate) {
      double excess = Math.max(Math.abs(speed) / mostSpeed, Math.abs(turnRate) / mostTurnRate);
      return excess <= 1 ? this : new Velocity(speed / excess, turnRate / excess);
    }
  }

  /**
   * Set or release the parking brake. A velocity other than zero is refused by a {@link
   * BrakeEngagedException} while it is set.
   *
   * @param set whether to set it
   */
  record Brake(boolean set) implements DriveCommand {}
}
