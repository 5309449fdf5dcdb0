package org.dfra.app.raster.embedded;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import org.dfra.app.raster.monitor.TrueTrajectory;
import org.dfra.app.raster.monitor.TruthSource;
import org.dfra.sim.world.Collision;
import org.dfra.sim.world.GroundTruth;
import org.dfra.sim.world.World;

/**
 * The true poses of robots, sampled from a simulated world in this JVM a hundred times a second of
 * its time. Confined to one thread.
 */
final class SimulatedTruth implements TruthSource {

  private static final Duration PERIOD = Duration.ofMillis(10);

  private final GroundTruth truth;
  private final InstantSource clock;
  private Instant next;

  /**
   * @param clock the world's clock
   */
  SimulatedTruth(World world, InstantSource clock) {
    this.truth = world.groundTruth();
    this.clock = clock;
    this.next = clock.instant();
  }

  /** Does not sample future times: that would delay the devices. */
  @Override
  public void readNew(TrueTrajectory way) {
    Instant now = clock.instant();
    for (; !next.isAfter(now); next = next.plus(PERIOD)) {
      truth.poses(next).forEach(way::add);
    }
  }

  @Override
  public List<Collision> collisions() {
    return truth.collisions();
  }
}
