package org.dfra.drivers.drive.rflex;

import org.dfra.core.config.Parameters;
import org.dfra.drivers.drive.rflex.RflexMessage.Axis;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.persona.DriveAttributes;

/**
 * How the wheels of an ATRV-Jr are told what to do: what the controller counts, and how fast they
 * get faster and slower. Pure.
 *
 * @param countsPerMetre counts for a metre, negative where the controller counts backwards
 * @param countsPerRadian counts for a radian, negative where it counts to the right
 * @param acceleration metres per second squared, while they are driven
 * @param yawAcceleration radians per second squared, likewise
 * @param stopDeceleration metres per second squared, when they are to stand
 * @param stopYawDeceleration radians per second squared, likewise
 * @param torque the most torque along x, in the controller's unit
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

  /** What the robot can, and how large it is with bumpers and wheels. */
  static final DriveAttributes ATRV_JR = new DriveAttributes(1, 2, 0.78, 0.64);

  /** Of CARMEN's driver; Player's has 90810 and 37000. */
  private static final double PER_METRE = 87_462.73;

  private static final double PER_RADIAN = 36_277.67;
  private static final double LEAST_COUNTS = 1000;
  private static final double MOST_COUNTS = 1_000_000;
  private static final double TORQUE = 30_000;
  private static final double MOST_TORQUE = 1_000_000;

  /** Seconds from the timer to the controller: two frames that are 10 ms apart, and some. */
  private static final double ON_THE_WAY = 0.03;

  /**
   * Seconds that braking may take at the most, so that some are left for silence; the way included.
   */
  private static final double LONGEST_BRAKING = 0.45;

  /** The parameters, see {@link RflexDriveImpl}. */
  static RflexDriveSettings from(Parameters parameters) {
    RflexDriveSettings wheels =
        new RflexDriveSettings(
            counts(parameters, "units_per_metre", PER_METRE),
            counts(parameters, "units_per_radian", PER_RADIAN),
            parameters.number("acceleration", 1, 0.05, 20),
            parameters.number("turn_acceleration", 2, 0.1, 40),
            parameters.number("stop_deceleration", 7, 0.05, 20),
            parameters.number("stop_turn_deceleration", 14, 0.1, 40),
            parameters.number("torque", TORQUE, 0, MOST_TORQUE),
            parameters.number("turn_torque", TORQUE, 0, MOST_TORQUE));
    wheels.check(parameters);
    return wheels;
  }

  /** Counts for a unit: how many, and in which direction. */
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
          isTurn ? "stop_turn_deceleration" : "stop_deceleration",
          "enough to stand in time: "
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

  /** Seconds until wheels stand that were as fast as they can, the way of the command included. */
  double braking() {
    return Math.max(
            ATRV_JR.maxSpeed() / stopDeceleration, ATRV_JR.maxYawRate() / stopYawDeceleration)
        + ON_THE_WAY;
  }

  /**
   * The frame that has an axis move so. Along x, 1 count per second takes the place of 0, as
   * reference drivers do it: 11 micrometres in a second, which no wheel turns by.
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
