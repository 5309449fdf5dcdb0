package org.dfra.core.geometry;

import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.dfra.geometry.Posable;
import org.dfra.geometry.Transform;
import org.ejml.data.DMatrix4x4;
import org.ejml.dense.fixed.CommonOps_DDF4;
import org.jspecify.annotations.Nullable;

/**
 * Frames that stand in each other: {@code odom -> base_link -> pan_tilt -> camera}. Safe for use by
 * several threads; each question is answered by what each frame was when it was looked at.
 *
 * <p>Composition: a point's coordinates in the camera, times the camera's transform, are its
 * coordinates in the pan-tilt; times the pan-tilt's, in the base; and so on up.
 */
public final class FrameTree {

  private final Map<String, Placed> frames = new ConcurrentHashMap<>();

  private record Placed(String parent, Transform transform) {}

  /**
   * Puts a frame into its parent, or moves it there.
   *
   * @throws IllegalArgumentException if it would stand in itself
   */
  public synchronized void put(String frame, String parent, Transform transform) {
    for (@Nullable String at = parent; at != null; at = parentOf(at)) {
      if (at.equals(frame)) {
        throw new IllegalArgumentException(
            "frame " + frame + " cannot stand in " + parent + ", which stands in it");
      }
    }
    frames.put(frame, new Placed(parent, transform));
  }

  /** Puts a module's frame where the module says it is now. */
  public void put(Posable module) throws RemoteException {
    put(module.frame(), module.parentFrame(), module.localTransform());
  }

  /**
   * Where one frame stands in another: takes coordinates in {@code frame} to coordinates in {@code
   * in}.
   *
   * @throws IllegalArgumentException if one of them is not known, or nothing connects them
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
}
