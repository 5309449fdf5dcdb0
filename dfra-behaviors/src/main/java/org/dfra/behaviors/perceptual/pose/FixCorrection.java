package org.dfra.behaviors.perceptual.pose;

import org.dfra.behaviors.perceptual.pose.FilterInput.LocalFix;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/** Corrects a {@link Belief}'s state by fixes. */
final class FixCorrection {

  private final TrackerSettings settings;
  private final MeasurementUpdate byCourse = new MeasurementUpdate(Belief.SIZE, 1);
  private final MeasurementUpdate byPosition = new MeasurementUpdate(Belief.SIZE, 2);

  FixCorrection(TrackerSettings settings) {
    this.settings = settings;
  }

  /** Corrects by a fix's position; false if the gate rejected it. */
  boolean position(LocalFix fix, DMatrixRMaj state, DMatrixRMaj covariance) {
    double cos = Math.cos(state.get(Belief.YAW));
    double sin = Math.sin(state.get(Belief.YAW));
    double armEast = cos * fix.forward() - sin * fix.left();
    double armNorth = sin * fix.forward() + cos * fix.left();
    int slow = Belief.GPS_BIAS + 2 * fix.slot();
    DMatrixRMaj jacobian = byPosition.jacobian;
    jacobian.zero();
    jacobian.set(0, Belief.EAST, 1);
    jacobian.set(1, Belief.NORTH, 1);
    jacobian.set(0, Belief.YAW, -armNorth);
    jacobian.set(1, Belief.YAW, armEast);
    jacobian.set(0, slow, 1);
    jacobian.set(1, slow + 1, 1);
    byPosition.innovation.set(
        0, 0, fix.east() - state.get(Belief.EAST) - armEast - state.get(slow));
    byPosition.innovation.set(
        1, 0, fix.north() - state.get(Belief.NORTH) - armNorth - state.get(slow + 1));
    CommonOps_DDRM.setIdentity(byPosition.noise);
    CommonOps_DDRM.scale(fix.sigma() * fix.sigma(), byPosition.noise);
    return byPosition.apply(state, covariance, settings.positionGate());
  }

  /**
   * Corrects by a fix's course; false if the gate rejected it.
   *
   * @param ahead direction of travel in the robot's frame, radians from its x, to the left is +
   */
  boolean course(LocalFix fix, double ahead, DMatrixRMaj state, DMatrixRMaj covariance) {
    double sigma = settings.gps().courseSigma(fix.speed());
    byCourse.jacobian.zero();
    byCourse.jacobian.set(0, Belief.YAW, 1);
    byCourse.innovation.set(
        0, 0, Math.IEEEremainder(fix.course() - ahead - state.get(Belief.YAW), 2 * Math.PI));
    byCourse.noise.set(0, 0, sigma * sigma);
    return byCourse.apply(state, covariance, settings.courseGate());
  }
}
