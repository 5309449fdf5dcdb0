package org.dfra.flow.effector;

/** The commands of a {@link PanTiltEffector}. */
public sealed interface PanTiltCommand extends Command {

  /**
   * Rotates to a direction and holds it. A direction outside the unit's limits is refused.
   *
   * @param pan about z, radians, to the left is +
   * @param tilt about y after pan, radians, up is +
   * @param speed of each axis, radians per second, above 0; limited to the unit's maximum
   */
  record PointAt(double pan, double tilt, double speed) implements PanTiltCommand {

    public PointAt {
      if (!Double.isFinite(pan) || !Double.isFinite(tilt)) {
        throw new IllegalArgumentException(
            "direction " + pan + " rad, " + tilt + " rad is not finite");
      }
      if (!(speed > 0)) {
        throw new IllegalArgumentException("speed " + speed + " rad/s is not > 0");
      }
    }
  }

  /** Stops at the current direction. */
  record Halt() implements PanTiltCommand {}
}
