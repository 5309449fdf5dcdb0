package org.dfra.core.geometry;

import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.dfra.geometry.Posable;
import org.dfra.geometry.Transform;
import org.ejml.data.DMatrix3x3;
import org.ejml.data.DMatrix4x4;
import org.ejml.dense.fixed.CommonOps_DDF4;
import org.jspecify.annotations.Nullable;

/**
 * A tree of coordinate frames: {@code odom -> base_link -> pan_tilt -> camera}. Thread-safe; each
 * query uses the value of each frame at the time it is read.
 *
 * <p>Composition: a point's coordinates in the camera, times the camera's transform, are its
 * coordinates in the pan-tilt; times the pan-tilt's, in the base; and so on up.
 */
public final class FrameTree {

  private final Map<String, Placed> frames = new ConcurrentHashMap<>();

  private record Placed(String parent, Transform transform) {}

  /**
   * Adds a frame to its parent, or updates its transform.
   *
   * @throws IllegalArgumentException if it would create a cycle
   */
  public synchronized void put(String frame, String parent, Transform transform) {
    for (@Nullable String at = parent; at != null; at = parentOf(at)) {
      if (at.equals(frame)) {
        throw new IllegalArgumentException(
            "frame " + frame + " cannot have the parent " + parent + ", which is its descendant");
      }
    }
    frames.put(frame, new Placed(parent, transform));
  }

  /** Updates a module's frame from the module's current pose. */
  public void put(Posable module) throws RemoteException {
    put(module.frame(), module.parentFrame(), module.localTransform());
  }

  /**
   * The pose of one frame in another: maps coordinates in {@code frame} to coordinates in {@code
   * in}.
   *
   * @throws IllegalArgumentException if one of them is unknown, or they are not connected
   */
  public Transform transform(String frame, String in) {
    List<String> up = pathUp(frame);
    List<String> other = pathUp(in);
    @Nullable String common = null;
    for (String candidate : up) {
      if (other.contains(candidate)) {
        common = candidate;
        break;
      }
    }
    if (common == null) {
      throw new IllegalArgumentException(
          "nothing connects frame "
              + frame
              + " (in "
              + up.get(up.size() - 1)
              + ") and frame "
              + in
              + " (in "
              + other.get(other.size() - 1)
              + ")");
    }
    DMatrix4x4 toCommon = matrix(frame, common);
    DMatrix4x4 fromCommon = new DMatrix4x4();
    if (!CommonOps_DDF4.invert(matrix(in, common), fromCommon)) {
      throw new AssertionError("a rigid transform has an inverse");
    }
    DMatrix4x4 whole = new DMatrix4x4();
    CommonOps_DDF4.mult(fromCommon, toCommon, whole);
    return TransformMatrices.transform(whole);
  }

  private DMatrix4x4 matrix(String frame, String ancestor) {
    DMatrix4x4 product = TransformMatrices.of(Transform.IDENTITY);
    String at = frame;
    while (!at.equals(ancestor)) {
      Placed placed = frames.get(at);
      if (placed == null) {
        throw new IllegalArgumentException("frame " + at + " was taken away meanwhile");
      }
      DMatrix4x4 next = new DMatrix4x4();
      CommonOps_DDF4.mult(TransformMatrices.of(placed.transform()), product, next);
      product = next;
      at = placed.parent();
    }
    return product;
  }

  private List<String> pathUp(String frame) {
    List<String> path = new ArrayList<>();
    for (@Nullable String at = frame; at != null; at = parentOf(at)) {
      path.add(at);
    }
    if (path.size() == 1 && frames.values().stream().noneMatch(p -> p.parent().equals(frame))) {
      throw new IllegalArgumentException(
          "there is no frame "
              + frame
              + "; there are "
              + frames.keySet().stream().sorted().toList());
    }
    return path;
  }

  private @Nullable String parentOf(String frame) {
    Placed placed = frames.get(frame);
    return placed == null ? null : placed.parent();
  }

  /** Converts transforms to homogeneous matrices, and back. */
  private static final class TransformMatrices {

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
}
