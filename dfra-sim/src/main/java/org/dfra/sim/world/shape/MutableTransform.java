package org.dfra.sim.world.shape;

/**
 * Position and rotation of a frame in the world: a point and the matrix that transforms the frame's
 * axes to the world's. Column by column: the frame's x axis points to (xx, yx, zx) in east, north,
 * up, its y axis to (xy, yy, zy), its z axis to (xz, yz, zz). Mutable, created once and set for
 * every measurement; confined to one thread.
 */
public final class MutableTransform {

  public double east;
  public double north;
  public double up;
  public double xx = 1;
  public double xy;
  public double xz;
  public double yx;
  public double yy = 1;
  public double yz;
  public double zx;
  public double zy;
  public double zz = 1;

  /** Copies another one. */
  public void set(MutableTransform other) {
    shift(other.east, other.north, other.up);
    xx = other.xx;
    xy = other.xy;
    xz = other.xz;
    yx = other.yx;
    yy = other.yy;
    yz = other.yz;
    zx = other.zx;
    zy = other.zy;
    zz = other.zz;
  }

  private void shift(double toEast, double toNorth, double toUp) {
    east = toEast;
    north = toNorth;
    up = toUp;
  }

  /**
   * Sets position and rotation: rotated first by roll about x, then by pitch about y, then by yaw
   * about z, each about an axis of the parent.
   *
   * @param roll radians, left side up is +
   * @param pitch radians, nose down is +
   * @param yawCos cosine of yaw, counter-clockwise seen from above is +
   * @param yawSin its sine
   */
  public void set(
      double east,
      double north,
      double up,
      double roll,
      double pitch,
      double yawCos,
      double yawSin) {
    shift(east, north, up);
    double cr = roll == 0 ? 1 : StrictMath.cos(roll);
    double sr = roll == 0 ? 0 : StrictMath.sin(roll);
    double cp = pitch == 0 ? 1 : StrictMath.cos(pitch);
    double sp = pitch == 0 ? 0 : StrictMath.sin(pitch);
    xx = yawCos * cp;
    xy = yawCos * sp * sr - yawSin * cr;
    xz = yawCos * sp * cr + yawSin * sr;
    yx = yawSin * cp;
    yy = yawSin * sp * sr + yawCos * cr;
    yz = yawSin * sp * cr - yawCos * sr;
    zx = -sp;
    zy = cp * sr;
    zz = cp * cr;
  }

  /** Sets it to the pose, in the world, of a frame with the given pose in a parent. */
  public void compose(MutableTransform parent, MutableTransform local) {
    double e =
        parent.east + parent.xx * local.east + parent.xy * local.north + parent.xz * local.up;
    double n =
        parent.north + parent.yx * local.east + parent.yy * local.north + parent.yz * local.up;
    double u = parent.up + parent.zx * local.east + parent.zy * local.north + parent.zz * local.up;
    double axx = parent.xx * local.xx + parent.xy * local.yx + parent.xz * local.zx;
    double axy = parent.xx * local.xy + parent.xy * local.yy + parent.xz * local.zy;
    double axz = parent.xx * local.xz + parent.xy * local.yz + parent.xz * local.zz;
    double ayx = parent.yx * local.xx + parent.yy * local.yx + parent.yz * local.zx;
    double ayy = parent.yx * local.xy + parent.yy * local.yy + parent.yz * local.zy;
    double ayz = parent.yx * local.xz + parent.yy * local.yz + parent.yz * local.zz;
    double azx = parent.zx * local.xx + parent.zy * local.yx + parent.zz * local.zx;
    double azy = parent.zx * local.xy + parent.zy * local.yy + parent.zz * local.zy;
    double azz = parent.zx * local.xz + parent.zy * local.yz + parent.zz * local.zz;
    shift(e, n, u);
    xx = axx;
    xy = axy;
    xz = axz;
    yx = ayx;
    yy = ayy;
    yz = ayz;
    zx = azx;
    zy = azy;
    zz = azz;
  }
}
