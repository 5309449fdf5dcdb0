package org.dfra.behaviors.perceptual.mines;

import java.util.List;
import org.dfra.behaviors.perceptual.mines.ImageMineDetector.ImageDetections;

/**
 * Images taken at about one time, at most one per band, with their viewpoints.
 *
 * @param views of the images, at least one
 */
public record MineObservation(List<LocatedDetections> views) {

  public MineObservation {
    views = List.copyOf(views);
  }

  /**
   * One image.
   *
   * @param viewpoint pose of the robot
   * @param detections in the image
   */
  public record LocatedDetections(Viewpoint viewpoint, ImageDetections detections) {

    /** Whether a mine at a map position would be visible. */
    public boolean covers(GroundPoint place) {
      return detections.covers(viewpoint.toBase(place));
    }

    /** Detections, in map coordinates. */
    public List<GroundPoint> points() {
      return detections.points().stream().map(viewpoint::toMap).toList();
    }
  }

  /**
   * Pose of a robot on the map.
   *
   * @param east metres
   * @param north metres
   * @param yaw radians, 0 is east, counter-clockwise is +
   */
  public record Viewpoint(double east, double north, double yaw) {

    /** From the robot's base, x forward, y left, to the map, x east, y north. */
    public GroundPoint toMap(GroundPoint spot) {
      double cos = Math.cos(yaw);
      double sin = Math.sin(yaw);
      return new GroundPoint(
          east + cos * spot.x() - sin * spot.y(), north + sin * spot.x() + cos * spot.y());
    }

    /** From the map to the robot's base. */
    public GroundPoint toBase(GroundPoint spot) {
      double cos = Math.cos(yaw);
      double sin = Math.sin(yaw);
      double dx = spot.x() - east;
      double dy = spot.y() - north;
      return new GroundPoint(cos * dx + sin * dy, cos * dy - sin * dx);
    }

    /** Distance to another, metres, regardless of yaw. */
    public double distance(Viewpoint other) {
      return Math.hypot(east - other.east, north - other.north);
    }

    /** Yaw difference to another, radians, 0 to π. */
    public double yawDifference(Viewpoint other) {
      return Math.abs(Math.IEEEremainder(yaw - other.yaw, 2 * Math.PI));
    }
  }

  /**
   * A point on the ground.
   *
   * @param x forward of a robot's base, or east; metres
   * @param y to the left of it, or north; metres
   */
  public record GroundPoint(double x, double y) {

    /** Metres to another. */
    public double distance(GroundPoint other) {
      return Math.hypot(x - other.x, y - other.y);
    }
  }
}
