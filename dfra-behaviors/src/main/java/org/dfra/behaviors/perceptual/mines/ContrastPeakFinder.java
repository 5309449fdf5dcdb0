package org.dfra.behaviors.perceptual.mines;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.dfra.behaviors.perceptual.mines.DetectionWindow.WindowGrid;
import org.dfra.behaviors.perceptual.mines.MineObservation.GroundPoint;
import org.jspecify.annotations.Nullable;

/** Finds mine-like contrast peaks in an image. */
final class ContrastPeakFinder {

  /** Minimum distance of two peaks, metres. */
  private static final double MIN_DISTANCE = 0.4;

  /**
   * Points within this distance of the maximum, with nearly equal contrast, determine the centre.
   */
  private static final double MIDDLE = 0.15; // metres

  private static final double NEARLY = 0.7; // of the best

  private ContrastPeakFinder() {}

  /**
   * A mine-like contrast peak.
   *
   * @param spot position in the frame of the base
   * @param strength its contrast, 1 or more
   */
  record Peak(GroundPoint spot, double strength) {}

  /** All peaks, the strongest first. */
  static List<Peak> find(DecodedImage image, WindowGrid windows, Contrast contrast) {
    double[] strengths = new double[windows.size()];
    List<Integer> candidates = new ArrayList<>();
    for (int i = 0; i < strengths.length; i++) {
      @Nullable DetectionWindow window = windows.at(i);
      strengths[i] = window == null ? 0 : contrast.score(image, window);
      if (strengths[i] >= 1) {
        candidates.add(i);
      }
    }
    candidates.sort(Comparator.comparingDouble(i -> -strengths[i]));
    List<Peak> found = new ArrayList<>();
    List<GroundPoint> peaks = new ArrayList<>();
    for (int candidate : candidates) {
      GroundPoint peak = windows.point(candidate);
      if (peaks.stream().allMatch(other -> peak.distance(other) > MIN_DISTANCE)) {
        peaks.add(peak);
        found.add(new Peak(middle(candidate, strengths, windows), strengths[candidate]));
      }
    }
    return found;
  }

  /** Centre of the points around the maximum with nearly equal contrast. */
  private static GroundPoint middle(int best, double[] strengths, WindowGrid windows) {
    int reach = (int) Math.round(MIDDLE / WindowGrid.STEP);
    int columns = windows.columns();
    double sum = 0;
    double x = 0;
    double y = 0;
    for (int row = best / columns - reach; row <= best / columns + reach; row++) {
      for (int column = best % columns - reach; column <= best % columns + reach; column++) {
        int index = row * columns + column;
        boolean isThere = row >= 0 && column >= 0 && column < columns && index < strengths.length;
        if (isThere && strengths[index] >= NEARLY * strengths[best]) {
          GroundPoint spot = windows.point(index);
          sum += strengths[index];
          x += strengths[index] * spot.x();
          y += strengths[index] * spot.y();
        }
      }
    }
    return new GroundPoint(x / sum, y / sum);
  }
}
