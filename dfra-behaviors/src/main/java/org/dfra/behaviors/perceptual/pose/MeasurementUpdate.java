package org.dfra.behaviors.perceptual.pose;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * The measurement update of a Kalman filter, with the covariance in Joseph's form. It is created
 * once for a size and reused.
 */
final class MeasurementUpdate {

  /** Measurement matrix; a row for each measured component. The caller fills it in. */
  final DMatrixRMaj jacobian;

  /** Innovation: measured minus expected. The caller fills it in. */
  final DMatrixRMaj innovation;

  /** Covariance of the measurement noise. The caller fills it in. */
  final DMatrixRMaj noise;

  private final DMatrixRMaj spread;
  private final DMatrixRMaj inverse;
  private final DMatrixRMaj crossed;
  private final DMatrixRMaj gain;
  private final DMatrixRMaj gainNoise;
  private final DMatrixRMaj weighted;
  private final DMatrixRMaj keep;
  private final DMatrixRMaj product;
  private final DMatrixRMaj shift;

  /**
   * @param size dimension of the state
   * @param measured dimension of the measurement
   */
  MeasurementUpdate(int size, int measured) {
    jacobian = new DMatrixRMaj(measured, size);
    innovation = new DMatrixRMaj(measured, 1);
    noise = new DMatrixRMaj(measured, measured);
    spread = new DMatrixRMaj(measured, measured);
    inverse = new DMatrixRMaj(measured, measured);
    crossed = new DMatrixRMaj(size, measured);
    gain = new DMatrixRMaj(size, measured);
    gainNoise = new DMatrixRMaj(size, measured);
    weighted = new DMatrixRMaj(measured, 1);
    keep = new DMatrixRMaj(size, size);
    product = new DMatrixRMaj(size, size);
    shift = new DMatrixRMaj(size, 1);
  }

  /**
   * Corrects the state and its covariance, unless the gate rejects the measurement.
   *
   * @param gate squared Mahalanobis distance of the innovation from which on it rejects
   * @return whether it was corrected
   */
  boolean apply(DMatrixRMaj state, DMatrixRMaj covariance, double gate) {
    CommonOps_DDRM.multTransB(covariance, jacobian, crossed);
    CommonOps_DDRM.mult(jacobian, crossed, spread);
    CommonOps_DDRM.addEquals(spread, noise);
    if (!CommonOps_DDRM.invert(spread, inverse)) {
      return false;
    }
    CommonOps_DDRM.mult(inverse, innovation, weighted);
    if (!(CommonOps_DDRM.dot(innovation, weighted) < gate)) {
      return false;
    }
    CommonOps_DDRM.mult(crossed, inverse, gain);
    CommonOps_DDRM.mult(gain, innovation, shift);
    CommonOps_DDRM.addEquals(state, shift);
    // (I − K·H)·P·(I − K·H)ᵀ + K·R·Kᵀ
    CommonOps_DDRM.setIdentity(keep);
    CommonOps_DDRM.multAdd(-1, gain, jacobian, keep);
    CommonOps_DDRM.mult(keep, covariance, product);
    CommonOps_DDRM.multTransB(product, keep, covariance);
    CommonOps_DDRM.mult(gain, noise, gainNoise);
    CommonOps_DDRM.multAddTransB(gainNoise, gain, covariance);
    symmetrize(covariance);
    return true;
  }

  /** Restores the symmetry that rounding errors break. */
  static void symmetrize(DMatrixRMaj matrix) {
    for (int i = 0; i < matrix.numRows; i++) {
      for (int j = 0; j < i; j++) {
        double mean = (matrix.get(i, j) + matrix.get(j, i)) / 2;
        matrix.set(i, j, mean);
        matrix.set(j, i, mean);
      }
    }
  }
}
