package org.dfra.core.geometry;

import org.dfra.geometry.Transform;
import org.ejml.data.DMatrix3x3;
import org.ejml.data.DMatrix4x4;

/** Converts transforms to homogeneous matrices, and back. */
final class TransformMatrices {

  private TransformMatrices() {}

  /** The matrix that maps a column (x, y, z, 1) in the frame to one in the parent. */
  static DMatrix4x4 of(Transform t) {
    double w = t.qw();
    double x = t.qx();
    double y = t.qy();
    double z = t.qz();
    return new DMatrix4x4(
        1 - 2 * (y * y + z * z),
        2 * (x * y - w * z),
        2 * (x * z + w * y),
        t.x(),
        2 * (x * y + w * z),
        1 - 2 * (x * x + z * z),
        2 * (y * z - w * x),
        t.y(),
        2 * (x * z - w * y),
        2 * (y * z + w * x),
        1 - 2 * (x * x + y * y),
        t.z(),
        0,
        0,
        0,
        1);
  }

  /** The transform of a rigid matrix. */
  static Transform transform(DMatrix4x4 m) {
    DMatrix3x3 r = new DMatrix3x3(m.a11, m.a12, m.a13, m.a21, m.a22, m.a23, m.a31, m.a32, m.a33);
    // Shepperd's method: divide by the greatest of the four, so that precision is kept near
    // rotations by π.
    double[] q = {
      1 + r.a11 + r.a22 + r.a33,
      1 + r.a11 - r.a22 - r.a33,
      1 - r.a11 + r.a22 - r.a33,
      1 - r.a11 - r.a22 + r.a33
    };
    int greatest = 0;
    for (int i = 1; i < q.length; i++) {
      if (q[i] > q[greatest]) {
        greatest = i;
      }
    }
    double[][] products = {
      {q[0], r.a32 - r.a23, r.a13 - r.a31, r.a21 - r.a12},
      {r.a32 - r.a23, q[1], r.a12 + r.a21, r.a31 + r.a13},
      {r.a13 - r.a31, r.a12 + r.a21, q[2], r.a23 + r.a32},
      {r.a21 - r.a12, r.a31 + r.a13, r.a23 + r.a32, q[3]}
    };
    double[] p = products[greatest];
    double length = Math.sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + p[3] * p[3]);
    return new Transform(
        m.a14, m.a24, m.a34, p[0] / length, p[1] / length, p[2] / length, p[3] / length);
  }
}
