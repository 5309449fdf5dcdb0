package org.dfra.sim.world;

import java.util.List;
import org.dfra.sim.world.noise.RandomStream;
import org.dfra.sim.world.render.Renderer;
import org.dfra.sim.world.render.RobotMesh;
import org.dfra.sim.world.render.Scenery;
import org.dfra.sim.world.shape.MutableTransform;

/**
 * Shared by all cameras of a world: the scenery, created for the first image, and the robots'
 * meshes. Confined to the world's monitor.
 */
final class RenderScene {

  private final List<VehicleBody> bodies;
  private final Scenery scenery;
  private final List<Renderer.PlacedRobot> placed;

  RenderScene(World world) {
    this.bodies = world.bodies();
    RandomStream draws = new RandomStream(world.description().seed()).substream("ground");
    this.scenery = new Scenery(world.description(), draws);
    this.placed =
        bodies.stream()
            .map(
                body ->
                    new Renderer.PlacedRobot(RobotMesh.of(body.vehicle), new MutableTransform()))
            .toList();
  }

  Scenery scenery() {
    return scenery;
  }

  /** All robots with their poses at a step; the next call overwrites it. */
  List<Renderer.PlacedRobot> robots(double[] row) {
    for (int i = 0; i < bodies.size(); i++) {
      bodies.get(i).transformAt(row, placed.get(i).pose());
    }
    return placed;
  }
}
