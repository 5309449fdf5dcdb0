package org.dfra.sim.world;

import java.time.Instant;
import org.dfra.sim.physics.PanTiltPhysics;
import org.dfra.sim.world.shape.MutableTransform;

/** The head of a pan-tilt unit: it points in the last commanded direction. */
final class SimulatedPanTilt implements PanTiltPhysics {

  private static final int PAN = 0;
  private static final int TILT = 1;
  private static final int WIDTH = 2;

  private final World world;
  private final int offset;
  private double pan; // guarded by the world's monitor
  private double tilt; // guarded by the world's monitor

  SimulatedPanTilt(World world, StateLayout slots) {
    this.world = world;
    this.offset = slots.allocate(WIDTH);
  }

  @Override
  public void point(Instant time, double toPan, double toTilt) {
    if (!Double.isFinite(toPan) || !Double.isFinite(toTilt)) {
      throw new IllegalArgumentException(
          "the pan-tilt unit cannot point to "
              + toPan
              + " rad, "
              + toTilt
              + " rad; give finite angles");
    }
    world.command(
        time,
        () -> {
          pan = toPan;
          tilt = toTilt;
        });
  }

  void write(double[] row) {
    row[offset + PAN] = pan;
    row[offset + TILT] = tilt;
  }

  /** Rotation of the head on its foot at a step. */
  void apply(double[] row, MutableTransform out) {
    double angle = row[offset + PAN];
    out.set(0, 0, 0, 0, -row[offset + TILT], StrictMath.cos(angle), StrictMath.sin(angle));
  }
}
