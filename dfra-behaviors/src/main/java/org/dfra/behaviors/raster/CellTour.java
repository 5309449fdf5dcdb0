package org.dfra.behaviors.raster;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.dfra.behaviors.raster.LaneSegmentSequence.LaneSegment;

/**
 * Optimizes the order of cells and the start corner of each, for short transit paths. The first is
 * the south-westernmost. For a given order the best corners are found exactly, by dynamic
 * programming; orders are improved by reversing parts and moving cells, until no change shortens
 * the tour. Deterministic.
 */
final class CellTour {

  /** Maximum length of a part that is reversed or moved across. */
  private static final int REACH = 24;

  private static final double GAIN = 1e-6; // metres

  private final List<BoustrophedonCell> cells;
  private final InteriorPathFinder interior;
  private final double[][] between; // from the exit of a cell's traversal to the entry of another's

  CellTour(List<BoustrophedonCell> cells, InteriorPathFinder interior) {
    this.cells = cells;
    this.interior = interior;
    this.between = new double[cells.size() * BoustrophedonCell.TRAVERSALS][];
  }

  /** The lanes of all cells in the order and direction in which they are driven. */
  List<LaneSegment> segments() {
    List<Integer> order = nearestFirst();
    double length = length(order);
    boolean isShorter = true;
    while (isShorter) {
      isShorter = false;
      for (int from = 1; from < order.size(); from++) {
        for (int to = from + 1; to < Math.min(order.size(), from + REACH); to++) {
          for (int change = 0; change < 3; change++) {
            List<Integer> tried = changed(order, from, to, change);
            double triedLength = length(tried);
            if (triedLength < length - GAIN) {
              order = tried;
              length = triedLength;
              isShorter = true;
            }
          }
        }
      }
    }
    List<LaneSegment> strokes = new ArrayList<>();
    int[] ways = ways(order);
    for (int i = 0; i < ways.length; i++) {
      strokes.addAll(cells.get(order.get(i)).traversal(ways[i]));
    }
    return strokes;
  }

  private static List<Integer> changed(List<Integer> order, int from, int to, int change) {
    List<Integer> changed = new ArrayList<>(order);
    List<Integer> part = changed.subList(from, to + 1);
    switch (change) {
      case 0 -> Collections.reverse(part);
      case 1 -> Collections.rotate(part, 1);
      default -> Collections.rotate(part, -1);
    }
    return changed;
  }

  private List<Integer> nearestFirst() {
    List<Integer> left = new ArrayList<>();
    for (int i = 0; i < cells.size(); i++) {
      left.add(i);
    }
    List<Integer> order = new ArrayList<>(List.of(left.remove(0)));
    while (!left.isEmpty()) {
      int last = order.get(order.size() - 1);
      int nearest = 0;
      double least = Double.POSITIVE_INFINITY;
      for (int i = 0; i < left.size(); i++) {
        double distance = nearest(last, left.get(i));
        if (distance < least) {
          least = distance;
          nearest = i;
        }
      }
      order.add(left.remove(nearest));
    }
    return order;
  }

  private double nearest(int cell, int other) {
    double least = Double.POSITIVE_INFINITY;
    for (int way = 0; way < BoustrophedonCell.TRAVERSALS; way++) {
      for (int then = 0; then < BoustrophedonCell.TRAVERSALS; then++) {
        least = Math.min(least, between(cell, way, other, then));
      }
    }
    return least;
  }

  private double length(List<Integer> order) {
    return Arrays.stream(lengths(order)[order.size() - 1]).min().orElseThrow();
  }

  /** Transit length up to each stage, for each traversal of that stage's cell. */
  private double[][] lengths(List<Integer> order) {
    double[][] lengths = new double[order.size()][BoustrophedonCell.TRAVERSALS];
    // it starts in the west, and northward if both are equal
    lengths[0] = new double[] {0, Double.POSITIVE_INFINITY, GAIN, Double.POSITIVE_INFINITY};
    for (int i = 1; i < lengths.length; i++) {
      for (int way = 0; way < BoustrophedonCell.TRAVERSALS; way++) {
        double least = Double.POSITIVE_INFINITY;
        for (int before = 0; before < BoustrophedonCell.TRAVERSALS; before++) {
          double step = between(order.get(i - 1), before, order.get(i), way);
          least = Math.min(least, lengths[i - 1][before] + step);
        }
        lengths[i][way] = least;
      }
    }
    return lengths;
  }

  private int[] ways(List<Integer> order) {
    double[][] lengths = lengths(order);
    int[] ways = new int[order.size()];
    int last = ways.length - 1;
    ways[last] = least(lengths[last]);
    for (int i = last; i > 0; i--) {
      double[] before = lengths[i - 1].clone();
      for (int way = 0; way < BoustrophedonCell.TRAVERSALS; way++) {
        before[way] += between(order.get(i - 1), way, order.get(i), ways[i]);
      }
      ways[i - 1] = least(before);
    }
    return ways;
  }

  private static int least(double[] values) {
    int least = 0;
    for (int i = 1; i < values.length; i++) {
      least = values[i] < values[least] ? i : least;
    }
    return least;
  }

  private double between(int cell, int way, int other, int then) {
    int row = cell * BoustrophedonCell.TRAVERSALS + way;
    if (between[row] == null) {
      between[row] = new double[between.length];
      Arrays.fill(between[row], Double.NaN);
    }
    int column = other * BoustrophedonCell.TRAVERSALS + then;
    if (Double.isNaN(between[row][column])) {
      between[row][column] =
          interior.distance(cells.get(cell).exit(way), cells.get(other).entry(then));
    }
    return between[row][column];
  }
}
