package org.dfra.sim.world;

import java.util.List;
import org.dfra.sim.world.noise.Draws;
import org.dfra.sim.world.picture.Model;
import org.dfra.sim.world.picture.Painter;
import org.dfra.sim.world.picture.Scenery;
import org.dfra.sim.world.shape.Stance;

/**
 * What all cameras of a world share: the scenery, made when the first picture is asked for, and how
 * the robots look. Confined to the world's monitor.
 */
final class Gallery {

  private final List<Body> bodies;
  private final Scenery scenery;
  private final List<Painter.Placed> placed;

  Gallery(World world) {
    this.bodies = world.bodies();
    Draws draws = new Draws(world.description().seed()).of("ground");
    this.scenery = new Scenery(world.description(), draws);
    this.placed =
        bodies.stream()
            .map(body -> new Painter.Placed(Model.of(body.vehicle), new Stance()))
            .toList();
  }

  Scenery scenery() {
    return scenery;
  }

  /** All robots where they are at a step; the next call overwrites it. */
  List<Painter.Placed> robots(double[] row) {
    for (int i = 0; i < bodies.size(); i++) {
      bodies.get(i).stance(row, placed.get(i).stance());
    }
    return placed;
  }
}
