package org.dfra.behaviors.perceptual.pose;

import org.ejml.data.DMatrixRMaj;

/**
 * What a small error of a {@link Belief} becomes in a step: a matrix F that is the identity but for
 * a few numbers, so that F·P·Fᵀ needs an eighth of what products of whole matrices do.
 *
 * <pre>
 *            east north yaw turn scale spin slow..
 *   east       1         *    *    *     *
 *   north           1    *    *    *     *
 *   yaw                  1    *          *
 *   slow..                                   keep
 * </pre>
 */
final class StateTransitionMatrix {

  private static final int SIZE = Belief.SIZE;

  private final double[] east = new double[Belief.GPS_BIAS];
  private final double[] north = new double[Belief.GPS_BIAS];
  private double yawByTurn;
  private double yawBySpin;
  private double keep;

  /**
   * Begins anew: nothing depends on anything else, and slow errors keep a part of what they are.
   */
  void clear(double decay) {
    yawByTurn = 0;
    yawBySpin = 0;
    keep = decay;
    for (int i = 0; i < Belief.GPS_BIAS; i++) {
      east[i] = 0;
      north[i] = 0;
    }
  }

  /** Where the place goes with a number of the state. */
  void setPositionTerms(int by, double toEast, double toNorth) {
    east[by] = toEast;
    north[by] = toNorth;
  }

  /** How the yaw goes with what the gyro shows at rest, and with the part that the wheels slip. */
  void setYawTerms(double byTurn, double bySpin) {
    yawByTurn = byTurn;
    yawBySpin = bySpin;
  }

  /** Makes F·P·Fᵀ of P. */
  void apply(DMatrixRMaj covariance) {
    double[] p = covariance.data;
    for (int column = 0; column < SIZE; column++) {
      apply(p, column, SIZE);
    }
    for (int row = 0; row < SIZE; row++) {
      apply(p, row * SIZE, 1);
    }
  }

  /** Makes F·v of v, which begins somewhere in an array and has so long a way between numbers. */
  private void apply(double[] p, int begin, int stride) {
    double toEast = 0;
    double toNorth = 0;
    for (int i = Belief.YAW; i < Belief.GPS_BIAS; i++) {
      double v = p[begin + i * stride];
      toEast += east[i] * v;
      toNorth += north[i] * v;
    }
    p[begin + Belief.EAST * stride] += toEast;
    p[begin + Belief.NORTH * stride] += toNorth;
    p[begin + Belief.YAW * stride] +=
        yawByTurn * p[begin + Belief.GYRO_BIAS * stride]
            + yawBySpin * p[begin + Belief.WHEEL_YAW_SCALE * stride];
    for (int i = Belief.GPS_BIAS; i < SIZE; i++) {
      p[begin + i * stride] *= keep;
    }
  }
}
