package org.dfra.sim.world.render;

import java.util.List;
import org.dfra.sim.world.noise.RandomStream;
import org.dfra.sim.world.shape.MutableTransform;

/**
 * A camera without noise: renders the image from its pose. First the shadows, then obstacles and
 * robots, last ground and sky where no object is.
 *
 * <p>Its pixels are square, row by row from the upper left, and the optical axis goes through the
 * image centre. Mutable, created once and used for every image; confined to one thread.
 */
public final class Renderer {

  /** Ground beyond this distance is textured as at it, metres. */
  private static final double FARTHEST = 3000;

  private static final double LEAF = 0.05; // metres
  private static final double LEAF_CONTRAST = 0.45; // of the brightness, peak to peak
  private static final double LEAF_WARMTH = 150; // hundredths of a kelvin, peak to peak

  private final Scenery scenery;
  private final RenderMode band;
  private final Rasterizer canvas;
  private final double[] middle = new double[3];
  private final double[] world = new double[3 * 64];

  /** A robot in the image: its mesh and its pose. */
  public record PlacedRobot(RobotMesh model, MutableTransform pose) {}

  /**
   * @param width pixels in a row
   * @param height rows
   * @param fieldOfView from the left edge to the right, radians
   */
  public Renderer(Scenery scenery, RenderMode band, int width, int height, double fieldOfView) {
    this.scenery = scenery;
    this.band = band;
    this.canvas = new Rasterizer(width, height, fieldOfView);
  }

  /** Focal length, pixels. */
  public double focalLength() {
    return canvas.focal;
  }

  /**
   * Renders an image.
   *
   * @param camera its pose: its optical axis is x, z is up in the image
   * @param placed the robots, including its own
   * @return its samples row by row from the upper left; the next image overwrites them
   */
  public int[] paint(MutableTransform camera, List<PlacedRobot> placed) {
    canvas.begin(camera);
    if (camera.up > 0) {
      if (band != RenderMode.LABELS && scenery.light.hasShadows()) {
        shadows(placed);
      }
      things(placed);
    }
    if (band != RenderMode.LABELS) {
      background();
    }
    return canvas.samples;
  }

  private void things(List<PlacedRobot> placed) {
    for (Scenery.Group group : scenery.groups) {
      if (canvas.mayShow(group.east(), group.north(), group.up(), group.radius())) {
        for (MeshFace facet : group.facets()) {
          fill(facet, facet.corners(), facet.nx(), facet.ny(), facet.nz());
        }
      }
    }
    for (PlacedRobot robot : placed) {
      MutableTransform at = robot.pose();
      robot.model().middle(at, middle);
      if (canvas.mayShow(middle[0], middle[1], middle[2], robot.model().radius)) {
        for (MeshFace facet : robot.model().facets) {
          double nx = at.xx * facet.nx() + at.xy * facet.ny() + at.xz * facet.nz();
          double ny = at.yx * facet.nx() + at.yy * facet.ny() + at.yz * facet.nz();
          double nz = at.zx * facet.nx() + at.zy * facet.ny() + at.zz * facet.nz();
          fill(facet, moved(facet, at), nx, ny, nz);
        }
      }
    }
  }

  private void fill(MeshFace facet, double[] corners, double nx, double ny, double nz) {
    for (int i = 0; 3 * i < facet.corners().length; i++) {
      canvas.corner(i, corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]);
    }
    int sample = scenery.light.surface(band, facet.paint(), nx, ny, nz);
    canvas.fill(nx, ny, nz, sample, facet.paint().leafy());
  }

  private double[] moved(MeshFace facet, MutableTransform at) {
    double[] own = facet.corners();
    for (int i = 0; i < own.length; i += 3) {
      world[i] = at.east + at.xx * own[i] + at.xy * own[i + 1] + at.xz * own[i + 2];
      world[i + 1] = at.north + at.yx * own[i] + at.yy * own[i + 1] + at.yz * own[i + 2];
      world[i + 2] = at.up + at.zx * own[i] + at.zy * own[i + 1] + at.zz * own[i + 2];
    }
    return world;
  }

  private void shadows(List<PlacedRobot> placed) {
    for (Scenery.Group group : scenery.groups) {
      if (mayShowShadow(group.east(), group.north(), group.up(), group.radius())) {
        for (MeshFace facet : group.facets()) {
          shadow(facet.corners(), facet.corners().length);
        }
      }
    }
    for (PlacedRobot robot : placed) {
      robot.model().middle(robot.pose(), middle);
      if (mayShowShadow(middle[0], middle[1], middle[2], robot.model().radius)) {
        for (MeshFace facet : robot.model().facets) {
          shadow(moved(facet, robot.pose()), facet.corners().length);
        }
      }
    }
  }

  /** The shadow of a ball lies within a larger one around the middle of its own. */
  private boolean mayShowShadow(double east, double north, double up, double radius) {
    Light light = scenery.light;
    double away = up / light.sunZ;
    return canvas.mayShow(
        east - away * light.sunX, north - away * light.sunY, 0, radius / light.sunZ + radius);
  }

  /** Marks the ground that a facet, in any orientation, shades from the sun. */
  private void shadow(double[] corners, int length) {
    Light light = scenery.light;
    for (int i = 0; 3 * i < length; i++) {
      double away = Math.max(0, corners[3 * i + 2]) / light.sunZ;
      canvas.corner(
          i, corners[3 * i] - away * light.sunX, corners[3 * i + 1] - away * light.sunY, 0);
    }
    canvas.shade();
  }

  /** Ground and sky, and the leaf texture of leafy objects. */
  private void background() {
    MutableTransform camera = canvas.camera();
    double step = 1 / canvas.focal;
    double up = Math.max(0, camera.up);
    double perPixel = step * step;
    for (int row = 0, at = 0; row < canvas.height; row++) {
      double high = (canvas.height / 2.0 - row - 0.5) * step;
      double left = (canvas.width / 2.0 - 0.5) * step;
      double rx = camera.xx + camera.xy * left + camera.xz * high;
      double ry = camera.yx + camera.yy * left + camera.yz * high;
      double rz = camera.zx + camera.zy * left + camera.zz * high;
      double length = 1 + high * high;
      for (int column = 0; column < canvas.width; column++, at++) {
        float nearness = canvas.inverseDepth[at];
        if (nearness > 0) {
          if (canvas.leafy[at]) {
            canvas.samples[at] = leaf(canvas.samples[at], rx, ry, rz, 1 / nearness);
          }
        } else if (rz < 0) {
          double away = Math.min(FARTHEST, up / -rz);
          canvas.samples[at] =
              scenery.meadow.sample(
                  band,
                  camera.east + away * rx,
                  camera.north + away * ry,
                  away * away * perPixel / -rz,
                  canvas.shaded[at]);
        } else {
          canvas.samples[at] =
              scenery.light.sky(band, Math.min(1, rz / Math.sqrt(length + left * left)));
        }
        left -= step;
        rx -= step * camera.xy;
        ry -= step * camera.yy;
        rz -= step * camera.zy;
      }
    }
  }

  /** The pattern of leaves on a surface, fixed to the world, coarser where it is far away. */
  private int leaf(int sample, double rx, double ry, double rz, double away) {
    MutableTransform camera = canvas.camera();
    double size = LEAF;
    while (size * canvas.focal < away) {
      size *= 2;
    }
    long e = (long) Math.floor((camera.east + away * rx) / size);
    long n = (long) Math.floor((camera.north + away * ry) / size);
    long u = (long) Math.floor((camera.up + away * rz) / size);
    double draw =
        RandomStream.uniformOf(
            RandomStream.bits(e * 73_856_093 ^ n * 19_349_663 ^ u * 83_492_791, 0));
    return band == RenderMode.THERMAL
        ? sample + (int) ((draw - 0.5) * LEAF_WARMTH)
        : Light.lit(sample, 1 + (draw - 0.5) * LEAF_CONTRAST);
  }

  /** The content of an image. */
  public enum RenderMode {
    /** Visible light: each sample is 0xRRGGBB. */
    VISIBLE,
    /** Heat: each sample is a temperature in hundredths of a kelvin. */
    THERMAL,
    /** Labels: each sample is the label of the visible object, 0 for none. */
    LABELS
  }
}
