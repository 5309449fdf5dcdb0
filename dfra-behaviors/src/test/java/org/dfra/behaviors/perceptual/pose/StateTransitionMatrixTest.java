package org.dfra.behaviors.perceptual.pose;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.MatrixFeatures_DDRM;
import org.ejml.dense.row.RandomMatrices_DDRM;
import org.junit.jupiter.api.Test;

class StateTransitionMatrixTest {

  @Test
  void isTheProductOfWholeMatrices() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    for (int i = 0; i < 100; i++) {
      double[] numbers = random.doubles(11, -2, 2).toArray();
      StateTransitionMatrix transition = new StateTransitionMatrix();
      transition.setPositionTerms(Belief.GYRO_BIAS, 7, 7); // of the step before
      transition.clear(numbers[0]);
      DMatrixRMaj whole = CommonOps_DDRM.identity(Belief.SIZE);
      for (int slow = Belief.GPS_BIAS; slow < Belief.SIZE; slow++) {
        whole.set(slow, slow, numbers[0]);
      }
      for (int by = Belief.YAW; by < Belief.GPS_BIAS; by++) {
        transition.setPositionTerms(by, numbers[2 * by - 3], numbers[2 * by - 2]);
        whole.set(Belief.EAST, by, numbers[2 * by - 3]);
        whole.set(Belief.NORTH, by, numbers[2 * by - 2]);
      }
      transition.setYawTerms(numbers[9], numbers[10]);
      whole.set(Belief.YAW, Belief.GYRO_BIAS, numbers[9]);
      whole.set(Belief.YAW, Belief.WHEEL_YAW_SCALE, numbers[10]);

      DMatrixRMaj covariance =
          RandomMatrices_DDRM.symmetricPosDef(Belief.SIZE, new Random(random.nextLong()));
      DMatrixRMaj product = new DMatrixRMaj(Belief.SIZE, Belief.SIZE);
      DMatrixRMaj expected = new DMatrixRMaj(Belief.SIZE, Belief.SIZE);
      CommonOps_DDRM.mult(whole, covariance, product);
      CommonOps_DDRM.multTransB(product, whole, expected);
      transition.apply(covariance);
      assertThat(MatrixFeatures_DDRM.isIdentical(covariance, expected, 1e-9))
          .as("-Ddfra.seed=%d, number %d: %s is not %s", seed, i, covariance, expected)
          .isTrue();
    }
  }
}
