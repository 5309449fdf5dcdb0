package org.dfra.behaviors.raster;

import java.util.ArrayList;
import java.util.List;
import org.locationtech.jts.algorithm.Distance;
import org.locationtech.jts.geom.Coordinate;

/**
 * A sequence of lane segments with the direction of each: the directions minimize the transit paths
 * for that order. They are found exactly, segment by segment from either end, so that the cost of
 * an insertion is known for every index.
 */
final class LaneSegmentSequence {

  /** Minimum gain of a plan that starts southward, metres. */
  private static final double NORTHWARD_FIRST = 1e-6;

  private static final int ROUNDS = 3;

  /** A segment, and the paths to it from its predecessor: one for each direction of both. */
  private static final class OrderedSegment {
    final LaneSegment stroke;
    final double[] from = new double[4]; // 2 × whether the one before is reversed + whether this is
    final double[] upTo = new double[2]; // minimum transit up to it, if it is reversed or not
    final double[] after = new double[2]; // minimum transit from it on

    OrderedSegment(LaneSegment stroke) {
      this.stroke = stroke;
    }
  }

  private final List<OrderedSegment> links = new ArrayList<>();
  private final InteriorPathFinder interior;

  /**
   * @param strokes the segments, at least one
   */
  LaneSegmentSequence(List<LaneSegment> strokes, InteriorPathFinder interior) {
    this.interior = interior;
    strokes.forEach(stroke -> links.add(new OrderedSegment(stroke)));
    for (int i = 1; i < links.size(); i++) {
      join(i);
    }
    measure();
  }

  /** Inserts each segment at its lowest cost; then removes and reinserts each once. */
  void insert(List<LaneSegment> strokes) {
    strokes.forEach(this::insert);
    for (int round = 1; round < ROUNDS; round++) {
      double before = length();
      for (LaneSegment stroke : strokes) {
        remove(stroke);
        insert(stroke);
      }
      if (length() > before - NORTHWARD_FIRST) {
        return;
      }
    }
  }

  /** All segments, each in its direction. */
  List<LaneSegment> segments() {
    List<LaneSegment> driven = new ArrayList<>();
    OrderedSegment first = links.get(0);
    double gain = first.after[0] - first.after[1];
    boolean isAlike = Math.abs(gain) <= NORTHWARD_FIRST;
    int way = (isAlike ? !isNorthward(first) : gain > 0) ? 1 : 0;
    driven.add(oriented(first.stroke, way));
    for (OrderedSegment link : links.subList(1, links.size())) {
      double onward = link.from[2 * way] + link.after[0];
      double turned = link.from[2 * way + 1] + link.after[1];
      way = onward <= turned ? 0 : 1;
      driven.add(oriented(link.stroke, way));
    }
    return driven;
  }

  private static boolean isNorthward(OrderedSegment link) {
    return link.stroke.to().y > link.stroke.from().y;
  }

  /** The length of all transit paths, metres. */
  private double length() {
    return Math.min(links.get(0).after[0], links.get(0).after[1]);
  }

  private void insert(LaneSegment stroke) {
    double least = Double.POSITIVE_INFINITY;
    int place = 0;
    for (int i = 0; i <= links.size(); i++) {
      if (isNear(i - 1, stroke) || isNear(i, stroke)) {
        // straight lines first: they are fast lower bounds
        if (with(stroke, i, Coordinate::distance) < least) {
          double length = with(stroke, i, interior::distance);
          if (length < least) {
            least = length;
            place = i;
          }
        }
      }
    }
    links.add(place, new OrderedSegment(stroke));
    join(place);
    join(place + 1);
    measure();
  }

  private void remove(LaneSegment stroke) {
    for (int i = 0; i < links.size(); i++) {
      if (links.get(i).stroke == stroke) {
        links.remove(i);
        join(i);
        measure();
        return;
      }
    }
  }

  private boolean isNear(int index, LaneSegment stroke) {
    return index >= 0
        && index < links.size()
        && Math.abs(links.get(index).stroke.strip() - stroke.strip()) <= 1;
  }

  private interface DistanceFunction {
    double distance(Coordinate a, Coordinate b);
  }

  /** The length of all transit paths if a segment were inserted before an index. */
  private double with(LaneSegment stroke, int place, DistanceFunction metric) {
    double least = Double.POSITIVE_INFINITY;
    for (int way = 0; way < 2; way++) {
      LaneSegment here = oriented(stroke, way);
      double there = place == 0 ? 0 : Double.POSITIVE_INFINITY;
      double onward = place == links.size() ? 0 : Double.POSITIVE_INFINITY;
      for (int other = 0; other < 2; other++) {
        if (place > 0) {
          OrderedSegment before = links.get(place - 1);
          Coordinate end = oriented(before.stroke, other).to();
          there = Math.min(there, before.upTo[other] + metric.distance(end, here.from()));
        }
        if (place < links.size()) {
          OrderedSegment after = links.get(place);
          Coordinate begin = oriented(after.stroke, other).from();
          onward = Math.min(onward, metric.distance(here.to(), begin) + after.after[other]);
        }
      }
      least = Math.min(least, there + onward);
    }
    return least;
  }

  private void join(int index) {
    if (index < 1 || index >= links.size()) {
      return;
    }
    OrderedSegment before = links.get(index - 1);
    OrderedSegment link = links.get(index);
    for (int i = 0; i < link.from.length; i++) {
      Coordinate end = oriented(before.stroke, i / 2).to();
      link.from[i] = interior.distance(end, oriented(link.stroke, i % 2).from());
    }
  }

  private void measure() {
    for (int i = 0; i < links.size(); i++) {
      OrderedSegment link = links.get(i);
      double[] before = i == 0 ? new double[2] : links.get(i - 1).upTo;
      for (int way = 0; way < 2; way++) {
        double least = Math.min(before[0] + link.from[way], before[1] + link.from[2 + way]);
        link.upTo[way] = i == 0 ? 0 : least;
      }
    }
    for (int i = links.size() - 1; i >= 0; i--) {
      OrderedSegment link = links.get(i);
      for (int way = 0; way < 2; way++) {
        link.after[way] = 0;
        if (i + 1 < links.size()) {
          OrderedSegment next = links.get(i + 1);
          link.after[way] =
              Math.min(next.from[2 * way] + next.after[0], next.from[2 * way + 1] + next.after[1]);
        }
      }
    }
  }

  private static LaneSegment oriented(LaneSegment stroke, int way) {
    return way == 0 ? stroke : stroke.reversed();
  }

  /**
   * A straight segment to be driven, in the planner's axes: x across the lanes, y along them,
   * metres.
   *
   * @param from its start
   * @param to its end
   * @param strip index of its strip, from 0
   */
  record LaneSegment(Coordinate from, Coordinate to, int strip) {

    LaneSegment reversed() {
      return new LaneSegment(to, from, strip);
    }

    double length() {
      return from.distance(to);
    }

    double distance(Coordinate point) {
      return Distance.pointToSegment(point, from, to);
    }
  }
}
