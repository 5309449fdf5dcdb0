package org.dfra.examples.mission;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.dfra.examples.mission.RobotLog.Sample;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.description.WorldDescription.ObstacleDescription;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.dfra.sim.world.shape.PlanarShape.Vertex;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;

/** Computes the true clearance between the bodies of a world. */
public final class GroundTruthClearance {

  private record Obstacle(Geometry shape, double radius) {}

  private final GeometryFactory shapes = new GeometryFactory();
  private final List<Obstacle> obstacles = new ArrayList<>();
  private final Map<String, VehicleDescription> vehicles = new HashMap<>();

  /**
   * @param world with the obstacles and robots
   */
  public GroundTruthClearance(WorldDescription world) {
    for (ObstacleDescription each : world.obstacles()) {
      if (each.footprint() instanceof Disc disc) {
        Coordinate middle = new Coordinate(disc.east(), disc.north());
        obstacles.add(new Obstacle(shapes.createPoint(middle), disc.radius()));
      } else if (each.footprint() instanceof Polygon polygon) {
        obstacles.add(new Obstacle(polygon(polygon), 0));
      }
    }
    world.vehicles().forEach(vehicle -> vehicles.put(vehicle.name(), vehicle));
  }

  private Geometry polygon(Polygon polygon) {
    List<Coordinate> ring = new ArrayList<>();
    for (Vertex corner : polygon.corners()) {
      ring.add(new Coordinate(corner.east(), corner.north()));
    }
    ring.add(ring.get(0));
    return shapes.createPolygon(ring.toArray(Coordinate[]::new));
  }

  private Geometry body(String robot, GroundTruthPose pose) {
    return body(robot, pose.east(), pose.north(), pose.yaw());
  }

  private Geometry body(String robot, double east, double north, double yaw) {
    VehicleDescription vehicle = vehicles.get(robot);
    if (vehicle == null) {
      throw new IllegalArgumentException("there is no robot " + robot);
    }
    double cos = Math.cos(yaw);
    double sin = Math.sin(yaw);
    double x = vehicle.length() / 2;
    double y = vehicle.width() / 2;
    double[][] corners = {{x, y}, {-x, y}, {-x, -y}, {x, -y}, {x, y}};
    Coordinate[] ring = new Coordinate[corners.length];
    for (int i = 0; i < ring.length; i++) {
      ring[i] =
          new Coordinate(
              east + cos * corners[i][0] - sin * corners[i][1],
              north + sin * corners[i][0] + cos * corners[i][1]);
    }
    return shapes.createPolygon(ring);
  }

  /** From a robot's body to the nearest other body, metres; 0 on contact. */
  public double clearance(String robot, Map<String, GroundTruthPose> poses) {
    Geometry body = body(robot, pose(robot, poses));
    double least = Double.POSITIVE_INFINITY;
    for (Obstacle each : obstacles) {
      least = Math.min(least, Math.max(0, body.distance(each.shape()) - each.radius()));
    }
    for (Map.Entry<String, GroundTruthPose> other : poses.entrySet()) {
      if (!other.getKey().equals(robot)) {
        least = Math.min(least, body.distance(body(other.getKey(), other.getValue())));
      }
    }
    return least;
  }

  /** Between two robots' bodies at their true positions in two samples, metres. */
  public double distance(String one, Sample at, String other, Sample there) {
    return body(one, at.east(), at.north(), at.yaw())
        .distance(body(other, there.east(), there.north(), there.yaw()));
  }

  private static GroundTruthPose pose(String robot, Map<String, GroundTruthPose> poses) {
    GroundTruthPose pose = poses.get(robot);
    if (pose == null) {
      throw new IllegalArgumentException("the position of " + robot + " is unknown");
    }
    return pose;
  }
}
