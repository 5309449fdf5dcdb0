package org.dfra.flow.effector;

/** What a {@link PanTiltEffector} can be told. */
public sealed interface PanTiltCommand extends Command {

  /**
   * Turn there and stay. A direction outside the unit's limits is refused.
   *
   * @param pan about z, radians, to the left is +
   * @param tilt about y after pan, radians, up is +
   * @param speed of each axis, radians per second, above 0; what is faster than the unit can is
   *     made slower
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

  /** Stop where it is now. */
  record Halt() implements PanTiltCommand {}
}
