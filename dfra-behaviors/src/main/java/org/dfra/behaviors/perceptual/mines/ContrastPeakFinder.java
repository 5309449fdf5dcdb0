package org.dfra.behaviors.perceptual.mines;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Finds what looks like mines in a picture. */
final class ContrastPeakFinder {

  /** Two that are nearer to each other are one, metres. */
  private static final double APART = 0.4;

  /** What is as near as this to the best place, and nearly as good, tells where the middle is. */
  private static final double MIDDLE = 0.15; // metres

  private static final double NEARLY = 0.7; // of the best

  private ContrastPeakFinder() {}

  /**
   * Something that looks like a mine.
   *
   * @param spot where, in the frame of the base
   * @param strength its contrast, from 1 on
   */
  record Peak(GroundPoint spot, double strength) {}

  /** All there is, the strongest first. */
  static List<Peak> find(DecodedImage picture, WindowGrid windows, Contrast contrast) {
    double[] strengths = new double[windows.size()];
    List<Integer> candidates = new ArrayList<>();
    for (int i = 0; i < strengths.length; i++) {
      @Nullable DetectionWindow window = windows.at(i);
      strengths[i] = window == null ? 0 : contrast.score(picture, window);
      if (strengths[i] >= 1) {
        candidates.add(i);
      }
    }
    candidates.sort(Comparator.comparingDouble(i -> -strengths[i]));
    List<Peak> found = new ArrayList<>();
    List<GroundPoint> peaks = new ArrayList<>();
    for (int candidate : candidates) {
      GroundPoint peak = windows.point(candidate);
      if (peaks.stream().allMatch(other -> peak.distance(other) > APART)) {
        peaks.add(peak);
        found.add(new Peak(middle(candidate, strengths, windows), strengths[candidate]));
      }
    }
    return found;
  }

  /** The middle of the places around the best one that are nearly as good. */
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
