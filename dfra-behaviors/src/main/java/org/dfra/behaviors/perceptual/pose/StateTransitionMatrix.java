package org.dfra.behaviors.perceptual.pose;

import org.ejml.data.DMatrixRMaj;

/**
 * The Jacobian F of a {@link Belief}'s state transition: the identity except for a few entries, so
 * that F·P·Fᵀ needs an eighth of the operations of dense products.
 *
 * <pre>
 *            east north yaw gyro scale yaw  bias..
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

  /** Resets it: no cross terms; GPS biases decay. */
  void clear(double decay) {
    yawByTurn = 0;
    yawBySpin = 0;
    keep = decay;
    for (int i = 0; i < Belief.GPS_BIAS; i++) {
      east[i] = 0;
      north[i] = 0;
    }
  }

  /** Derivative of the position by a state. */
  void setPositionTerms(int by, double toEast, double toNorth) {
    east[by] = toEast;
    north[by] = toNorth;
  }

  /** Derivative of the yaw by the gyro bias, and by the wheel yaw scale. */
  void setYawTerms(double byTurn, double bySpin) {
    yawByTurn = byTurn;
    yawBySpin = bySpin;
  }

  /** Replaces P by F·P·Fᵀ. */
  void apply(DMatrixRMaj covariance) {
    double[] p = covariance.data;
    for (int column = 0; column < SIZE; column++) {
      apply(p, column, SIZE);
    }
    for (int row = 0; row < SIZE; row++) {
      apply(p, row * SIZE, 1);
    }
  }

  /** Replaces a vector v by F·v; v has an offset and a stride in its array. */
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
