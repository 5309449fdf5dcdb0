package org.dfra.drivers.drive.rflex;

import org.dfra.core.config.Parameters;
import org.dfra.drivers.drive.rflex.RflexMessage.Axis;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.persona.DriveAttributes;

/**
 * Settings of the drive of an ATRV-Jr: the controller's counts, accelerations and torques. Pure.
 *
 * @param countsPerMetre counts for a metre, negative where the controller counts backwards
 * @param countsPerRadian counts for a radian, negative where it counts to the right
 * @param acceleration metres per second squared, while driving
 * @param yawAcceleration radians per second squared, the same
 * @param stopDeceleration metres per second squared, when stopping
 * @param stopYawDeceleration radians per second squared, the same
 * @param torque maximum torque along x, in the controller's unit
 * @param yawTorque the same about z
 */
record RflexDriveSettings(
    double countsPerMetre,
    double countsPerRadian,
    double acceleration,
    double yawAcceleration,
    double stopDeceleration,
    double stopYawDeceleration,
    double torque,
    double yawTorque) {

  /** The robot's maximum velocities, and its size with bumpers and wheels. */
  static final DriveAttributes ATRV_JR = new DriveAttributes(1, 2, 0.78, 0.64);

  /** From CARMEN's driver; Player's driver has 90810 and 37000. */
  private static final double PER_METRE = 87_462.73;

  private static final double PER_RADIAN = 36_277.67;
  private static final double LEAST_COUNTS = 1000;
  private static final double MOST_COUNTS = 1_000_000;
  private static final double TORQUE = 30_000;
  private static final double MOST_TORQUE = 1_000_000;

  /** Delay from the timer to the controller, seconds: two frames 10 ms apart, and a margin. */
  private static final double ON_THE_WAY = 0.03;

  /**
   * Maximum stopping time including the transmission delay, seconds, so that some time is left for
   * the command timeout.
   */
  private static final double LONGEST_BRAKING = 0.45;

  /** Reads the parameters, see {@link RflexDriveImpl}. */
  static RflexDriveSettings from(Parameters parameters) {
    RflexDriveSettings wheels =
        new RflexDriveSettings(
            counts(parameters, "units_per_metre", PER_METRE),
            counts(parameters, "units_per_radian", PER_RADIAN),
            parameters.number("acceleration", 1, 0.05, 20),
            parameters.number("yaw_acceleration", 2, 0.1, 40),
            parameters.number("stop_deceleration", 7, 0.05, 20),
            parameters.number("stop_yaw_deceleration", 14, 0.1, 40),
            parameters.number("torque", TORQUE, 0, MOST_TORQUE),
            parameters.number("yaw_torque", TORQUE, 0, MOST_TORQUE));
    wheels.check(parameters);
    return wheels;
  }

  /** Counts per unit; the sign is the direction. */
  static double counts(Parameters parameters, String name, double usual) {
    double counts = parameters.number(name, usual, -MOST_COUNTS, MOST_COUNTS);
    if (Math.abs(counts) < LEAST_COUNTS) {
      throw parameters.fault(
          name, "1000 to 1000000 counts either way, negative where it counts backwards", null);
    }
    return counts;
  }

  static double countsPerMetre(Parameters parameters) {
    return counts(parameters, "units_per_metre", PER_METRE);
  }

  static double countsPerRadian(Parameters parameters) {
    return counts(parameters, "units_per_radian", PER_RADIAN);
  }

  private void check(Parameters parameters) {
    if (braking() > LONGEST_BRAKING) {
      boolean isTurn =
          ATRV_JR.maxYawRate() / stopYawDeceleration > ATRV_JR.maxSpeed() / stopDeceleration;
      throw parameters.fault(
          isTurn ? "stop_yaw_deceleration" : "stop_deceleration",
          "enough to stop in time: "
              + Math.ceil(
                      (isTurn ? ATRV_JR.maxYawRate() : ATRV_JR.maxSpeed())
                          * 100
                          / (LONGEST_BRAKING - ON_THE_WAY))
                  / 100
              + (isTurn ? " rad/s²" : " m/s²")
              + " or more",
          null);
    }
  }

  /** Stopping time from full speed, including the transmission delay, seconds. */
  double braking() {
    return Math.max(
            ATRV_JR.maxSpeed() / stopDeceleration, ATRV_JR.maxYawRate() / stopYawDeceleration)
        + ON_THE_WAY;
  }

  /**
   * The frame that sets the velocity of an axis. Along x, 0 is replaced by 1 count per second, as
   * in reference drivers: 11 micrometres per second, at which no wheel turns.
   */
  byte[] frame(Axis axis, Velocity commanded) {
    boolean isAlong = axis == Axis.TRANSLATION;
    double perUnit = isAlong ? countsPerMetre : countsPerRadian;
    long velocity = Math.round((isAlong ? commanded.speed() : commanded.yawRate()) * perUnit);
    double by =
        commanded.isZero()
            ? (isAlong ? stopDeceleration : stopYawDeceleration)
            : (isAlong ? acceleration : yawAcceleration);
    return RflexCommands.velocity(
        axis,
        isAlong && velocity == 0 ? 1 : velocity,
        Math.round(by * Math.abs(perUnit)),
        Math.round(isAlong ? torque : yawTorque));
  }
}
