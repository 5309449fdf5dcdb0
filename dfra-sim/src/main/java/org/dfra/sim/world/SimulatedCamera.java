package org.dfra.sim.world;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dfra.sim.physics.CameraInput;
import org.dfra.sim.world.GroundTruth.MineSighting;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.description.WorldDescription.MineDescription;
import org.dfra.sim.world.noise.RandomStream;
import org.dfra.sim.world.render.Renderer;
import org.dfra.sim.world.render.Renderer.RenderMode;
import org.dfra.sim.world.shape.MutableTransform;
import org.jspecify.annotations.Nullable;

/**
 * Simulates a camera's sensor: the rendered image and white noise on each pixel. On a multicopter
 * it is stabilised level.
 */
final class SimulatedCamera implements CameraInput {

  private static final int TABLE_BITS = 10;
  private static final int MASK = (1 << TABLE_BITS) - 1;

  private final World world;
  private final DeviceMount mount;
  private final RandomStream draws;
  private final RenderMode band;
  private final int width;
  private final int height;
  private final double fieldOfView;
  private final int[] noise; // the quantiles of the normal distribution, in units of a sample
  private @Nullable Renderer painter; // guarded by the world's monitor
  private @Nullable Renderer labeller; // guarded by the world's monitor

  SimulatedCamera(World world, DeviceMount mount, DeviceDescription device, RandomStream draws) {
    VehicleType type = mount.body().vehicle.type();
    this.world = world;
    this.mount = mount;
    this.draws = draws.substream("pixels");
    this.band = device.kind() == DeviceKind.THERMAL ? RenderMode.THERMAL : RenderMode.VISIBLE;
    this.width = (int) device.parameter("width", type);
    this.height = (int) device.parameter("height", type);
    this.fieldOfView = device.parameter("field_of_view", type);
    double white =
        device.parameter("white_noise_sigma", type) * (band == RenderMode.THERMAL ? 100 : 1);
    this.noise = new int[1 << TABLE_BITS];
    for (int i = 0; i < noise.length; i++) {
      long inTheMiddle = (2L * i + 1) << (Long.SIZE - TABLE_BITS - 1);
      noise[i] = (int) Math.round(white * RandomStream.gaussianOf(inTheMiddle));
    }
  }

  @Override
  public Frame capture(Instant time) {
    synchronized (world.monitor()) {
      long step = world.stepAt(time);
      double[] row = world.row(step);
      RenderScene scene = world.renderScene();
      Renderer painting = painter;
      if (painting == null) {
        painting = new Renderer(scene.scenery(), band, width, height, fieldOfView);
        painter = painting;
      }
      int[] samples = painting.paint(mount.at(row), scene.robots(row)).clone();
      if (band == RenderMode.THERMAL) {
        addNoise(samples, draws.bits(step));
      } else {
        addNoiseToColours(samples, draws.bits(step));
      }
      return new Frame(width, height, samples);
    }
  }

  private void addNoise(int[] samples, long seed) {
    for (int i = 0; i < samples.length; i++) {
      samples[i] += noise[(int) RandomStream.bits(seed, i) & MASK];
    }
  }

  private void addNoiseToColours(int[] samples, long seed) {
    for (int i = 0; i < samples.length; i++) {
      long bits = RandomStream.bits(seed, i);
      int colour = samples[i];
      int red = byteOf((colour >> 16 & 0xFF) + noise[(int) bits & MASK]);
      int green = byteOf((colour >> 8 & 0xFF) + noise[(int) (bits >>> TABLE_BITS) & MASK]);
      int blue = byteOf((colour & 0xFF) + noise[(int) (bits >>> 2 * TABLE_BITS) & MASK]);
      samples[i] = red << 16 | green << 8 | blue;
    }
  }

  private static int byteOf(int value) {
    return Math.max(0, Math.min(255, value));
  }

  /** The mines visible in the image at a time, by the pixels that show them. */
  List<MineSighting> mines(Instant time) {
    synchronized (world.monitor()) {
      double[] row = world.row(world.stepAt(time));
      RenderScene scene = world.renderScene();
      Renderer labelling = labeller;
      if (labelling == null) {
        labelling = new Renderer(scene.scenery(), RenderMode.LABELS, width, height, fieldOfView);
        labeller = labelling;
      }
      MutableTransform camera = mount.at(row);
      int[] labels = labelling.paint(camera, scene.robots(row));
      List<MineDescription> mines = world.description().mines();
      long[] pixels = new long[mines.size() + 1];
      double[] columns = new double[pixels.length];
      double[] rows = new double[pixels.length];
      for (int i = 0; i < labels.length; i++) {
        pixels[labels[i]]++;
        columns[labels[i]] += i % width + 0.5;
        rows[labels[i]] += i / width + 0.5;
      }
      List<MineSighting> seen = new ArrayList<>();
      for (int i = 1; i < pixels.length; i++) {
        if (pixels[i] > 0) {
          MineDescription mine = mines.get(i - 1);
          seen.add(
              new MineSighting(
                  mine.name(),
                  (int) pixels[i],
                  columns[i] / pixels[i],
                  rows[i] / pixels[i],
                  distance(camera, mine)));
        }
      }
      return seen;
    }
  }

  private static double distance(MutableTransform camera, MineDescription mine) {
    double x = mine.east() - camera.east;
    double y = mine.north() - camera.north;
    double z = mine.height() / 2 - camera.up;
    return Math.sqrt(x * x + y * y + z * z);
  }
}
