package org.dfra.sim.world;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.dfra.sim.world.shape.ObstacleIndex;
import org.dfra.sim.world.shape.OrientedRectangle;
import org.dfra.sim.world.shape.StaticObstacle;

/**
 * Detects obstacles in a body's path and records collisions. Continued contact with the same thing
 * is one collision; a new one counts after a second without contact. Confined to the world's
 * monitor.
 */
final class CollisionDetector {

  static final int NOTHING = -1;

  private static final long MIN_GAP = Math.round(1 / World.STEP_SECONDS); // steps

  /** A collision without its time, which the world adds. */
  record Noted(long step, String robot, String other, double speed, double east, double north) {}

  private final ObstacleIndex solids;
  private final List<VehicleBody> bodies;
  private final int[] near;
  private final Map<Long, Long> lastTouch = new HashMap<>();
  private final List<Noted> collisions = new ArrayList<>();

  /**
   * @param bodies all robots; may grow until the first step
   */
  CollisionDetector(ObstacleIndex solids, List<VehicleBody> bodies) {
    this.solids = solids;
    this.bodies = bodies;
    this.near = new int[solids.size()];
  }

  /**
   * The obstacle or body that a body touches: the number of a solid, or a number above those for a
   * body.
   */
  int findCollision(VehicleBody body) {
    OrientedRectangle box = body.box;
    int count = solids.query(body.east, body.north, box.radius(), near);
    for (int i = 0; i < count; i++) {
      StaticObstacle solid = solids.solid(near[i]);
      if (body.up <= solid.height() && box.touches(solid)) {
        return near[i];
      }
    }
    for (int i = 0; i < bodies.size(); i++) {
      VehicleBody other = bodies.get(i);
      if (other != body
          && body.up <= other.up + other.vehicle.height()
          && other.up <= body.up + body.vehicle.height()
          && box.touches(other.box)) {
        return solids.size() + i;
      }
    }
    return NOTHING;
  }

  /**
   * Records a collision of a body.
   *
   * @param hit result of {@link #findCollision}
   * @param eastward velocity before the impact, metres per second
   */
  void record(
      VehicleBody body, int hit, long step, double eastward, double northward, double upward) {
    boolean isBody = hit >= solids.size();
    long key =
        isBody
            ? key(
                solids.size() + Math.min(body.index, hit - solids.size()),
                Math.max(body.index, hit - solids.size()))
            : key(hit, body.index);
    Long before = lastTouch.put(key, step);
    if (before != null && step - before <= MIN_GAP) {
      return;
    }
    double x = eastward;
    double y = northward;
    double z = upward;
    String name;
    if (isBody) {
      VehicleBody other = bodies.get(hit - solids.size());
      name = other.vehicle.name();
      x -= other.eastward;
      y -= other.northward;
      z -= other.upward;
    } else {
      name = solids.solid(hit).name();
    }
    double speed = Math.sqrt(x * x + y * y + z * z);
    collisions.add(new Noted(step, body.vehicle.name(), name, speed, body.east, body.north));
  }

  private static long key(long one, long other) {
    return one << 32 | other;
  }

  /** All collisions so far, in order. */
  List<Noted> collisions() {
    return List.copyOf(collisions);
  }
}
