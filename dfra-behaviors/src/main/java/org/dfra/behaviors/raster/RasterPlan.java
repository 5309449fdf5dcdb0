package org.dfra.behaviors.raster;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.dfra.behavior.RasterGoal;
import org.dfra.behaviors.raster.LaneSegmentSequence.LaneSegment;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.Leg;
import org.dfra.geometry.LocalPosition;
import org.locationtech.jts.algorithm.Orientation;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Polygon;

/**
 * The plan of a region search: parallel, evenly spaced lanes, driven back and forth one after the
 * other, with short lanes along the outline where it slants.
 *
 * <p>Guarantees, in the plane of the region's frame: every point of the region lies within half a
 * swath of a lane, to a micrometre; lanes and transit paths lie inside the region, to a micrometre;
 * the reversed plan has the same waypoints in reverse order. A spacing greater than the region's
 * width gives one lane along its middle. Immutable.
 */
public final class RasterPlan {

  /** Lanes run from south to north and back, and the first one is in the west. */
  public static final double NORTHWARD = 0;

  private final Region region;
  private final double swath;
  private final double spacing;
  private final List<LocalPosition> path;
  private final List<GeoPosition> waypoints;
  private final List<Lane> lanes;

  private RasterPlan(
      Region region,
      double swath,
      double spacing,
      List<LocalPosition> path,
      List<GeoPosition> waypoints,
      List<Integer> laneStarts) {
    this.region = region;
    this.swath = swath;
    this.spacing = spacing;
    this.path = List.copyOf(path);
    this.waypoints = List.copyOf(waypoints);
    this.lanes = laneStarts.stream().map(this::lane).toList();
  }

  private Lane lane(int start) {
    return new Lane(
        path.get(start),
        path.get(start + 1),
        new Leg(waypoints.get(start), waypoints.get(start + 1)),
        start);
  }

  /**
   * Plans for a goal, with lanes to the north and back.
   *
   * @throws org.dfra.behavior.GoalRefusedException if its region is invalid, or needs too many
   *     lanes
   */
  public static RasterPlan of(RasterGoal goal) {
    RasterPlan plan = of(Region.of(goal.region()), goal.swath(), goal.spacing(), NORTHWARD);
    return goal.reversed() ? plan.reversed() : plan;
  }

  /**
   * Plans lanes over a region.
   *
   * @param swath width of the strip that the robot sees, metres, above 0
   * @param spacing maximum distance between lanes, metres, above 0 and at most the swath
   * @param laneBearing direction of the first lane, radians, clockwise from north; the lanes follow
   *     each other to its right
   * @throws org.dfra.behavior.GoalRefusedException if there would be too many lanes
   */
  public static RasterPlan of(Region region, double swath, double spacing, double laneBearing) {
    if (!(spacing > 0 && spacing <= swath && Double.isFinite(swath + laneBearing))) {
      throw new IllegalArgumentException(
          "lanes "
              + spacing
              + " m apart do not cover with a swath of "
              + swath
              + " m; give a spacing not greater than the swath");
    }
    LaneAxes axes = new LaneAxes(laneBearing);
    Polygon polygon = axes.of(region.polygon());
    StripDecomposition lines = new StripDecomposition(polygon, spacing, swath, region.centre());
    InteriorPathFinder interior = new InteriorPathFinder(polygon);
    List<LaneSegment> tour =
        new CellTour(BoustrophedonCell.of(polygon, lines), interior).segments();
    LaneSegmentSequence order = new LaneSegmentSequence(tour, interior);
    order.insert(new CoverageGapFiller(polygon, lines, swath / 2).fill());

    List<Coordinate> way = new ArrayList<>();
    List<Integer> laneStarts = new ArrayList<>();
    for (LaneSegment stroke : order.segments()) {
      connect(way, stroke.from(), interior);
      laneStarts.add(way.size() - 1);
      way.add(stroke.to());
    }
    List<LocalPosition> path = way.stream().map(axes::local).toList();
    List<GeoPosition> waypoints =
        path.stream().map(at -> region.onGround(at.east(), at.north())).toList();
    return new RasterPlan(region, swath, lines.width(), path, waypoints, laneStarts);
  }

  private static void connect(List<Coordinate> way, Coordinate to, InteriorPathFinder interior) {
    if (way.isEmpty()) {
      way.add(to);
      return;
    }
    List<Coordinate> between = interior.path(way.get(way.size() - 1), to);
    for (Coordinate each : between.subList(1, between.size())) {
      if (each.distance(way.get(way.size() - 1)) > 0) {
        way.add(each);
      }
    }
  }

  /** The same waypoints in reverse order: the last lane first, each in the opposite direction. */
  public RasterPlan reversed() {
    List<LocalPosition> back = new ArrayList<>(path);
    List<GeoPosition> points = new ArrayList<>(waypoints);
    Collections.reverse(back);
    Collections.reverse(points);
    List<Integer> starts = new ArrayList<>();
    lanes.forEach(lane -> starts.add(0, path.size() - 2 - lane.waypoint()));
    return new RasterPlan(region, swath, spacing, back, points, starts);
  }

  /** The searched region; its frame is that of the lanes and the path. */
  public Region region() {
    return region;
  }

  /** Width of the strip that the robot sees, metres. */
  public double swath() {
    return swath;
  }

  /**
   * Distance between lanes, metres: the requested spacing, or slightly less (or a thousandth more,
   * where the last lane would cover only a millimetre).
   */
  public double spacing() {
    return spacing;
  }

  /** The lanes in the order in which they are driven; at least one. */
  public List<Lane> lanes() {
    return lanes;
  }

  /** The waypoints in driving order, WGS84, height 0; at least two. */
  public List<GeoPosition> waypoints() {
    return waypoints;
  }

  /** The waypoints in the region's frame, ENU, metres, up 0. */
  public List<LocalPosition> path() {
    return path;
  }

  /** The length of the whole path, metres. */
  public double length() {
    double length = 0;
    for (int i = 1; i < path.size(); i++) {
      LocalPosition a = path.get(i - 1);
      LocalPosition b = path.get(i);
      length += Math.hypot(b.east() - a.east(), b.north() - a.north());
    }
    return length;
  }

  /**
   * Coverage of the region by a driven path.
   *
   * @param driven positions of the robot, in the region's frame, ENU, metres, connected by straight
   *     lines
   * @param seen width of the strip that it saw, metres, above 0
   */
  public Coverage coverage(List<LocalPosition> driven, double seen) {
    return new CoverageGrid(region.polygon(), seen, CoverageGrid.FINENESS).of(driven);
  }

  /**
   * Coverage map of a driven path, for display; {@link #coverage} counts more exactly.
   *
   * @param driven positions of the robot, as for {@link #coverage}
   * @param seen width of the strip that it saw, metres, above 0
   */
  public CoverageMap coverageMap(List<LocalPosition> driven, double seen) {
    return new CoverageGrid(region.polygon(), seen, CoverageGrid.COARSENESS).map(driven);
  }

  /**
   * The planner's axes: y along the lanes, x across them to the right, origin at the region's
   * centre. These are east and north where the lanes run northward.
   */
  private static final class LaneAxes {

    private final double sin;
    private final double cos;

    /**
     * @param bearing of the lanes, radians, clockwise from north
     */
    LaneAxes(double bearing) {
      this.sin = Math.sin(bearing);
      this.cos = Math.cos(bearing);
    }

    /** An outline, east and north, in these axes, and counter-clockwise. */
    Polygon of(Polygon outline) {
      Coordinate[] ring = outline.getExteriorRing().getCoordinates().clone();
      for (int i = 0; i < ring.length; i++) {
        double east = ring[i].x;
        double north = ring[i].y;
        ring[i] = new Coordinate(east * cos - north * sin, east * sin + north * cos);
      }
      Polygon turned = outline.getFactory().createPolygon(ring);
      boolean isCounterClockwise = Orientation.isCCW(turned.getCoordinates());
      return isCounterClockwise ? turned : turned.reverse();
    }

    /** A point in these axes, in the region's frame. */
    LocalPosition local(Coordinate point) {
      return new LocalPosition(point.x * cos + point.y * sin, point.y * cos - point.x * sin, 0);
    }
  }

  /**
   * A straight lane of a raster, as it is driven.
   *
   * @param from start, in the region's frame, ENU, metres, up 0
   * @param to end, likewise
   * @param leg the same in WGS84, height 0
   * @param waypoint index of the plan's waypoint at its start, from 0; it ends at the next
   */
  public record Lane(LocalPosition from, LocalPosition to, Leg leg, int waypoint) {

    /** Metres. */
    public double length() {
      return Math.hypot(to.east() - from.east(), to.north() - from.north());
    }
  }

  /**
   * Coverage of a region.
   *
   * @param share of the region's area that was seen at least once, 0 to 1
   * @param overlap share of the region's area that was seen on two passes or more, 0 to 1; a pass
   *     over a point ends when the robot has driven a swath's width without seeing it
   * @param cellSize side of the squares that were counted, metres; the error of the shares is about
   *     one square along the edge of the seen area
   */
  public record Coverage(double share, double overlap, double cellSize) {}
}
