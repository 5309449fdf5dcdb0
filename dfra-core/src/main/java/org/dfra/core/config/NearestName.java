package org.dfra.core.config;

import java.util.Collection;
import java.util.Comparator;
import java.util.Optional;

/** Finds the name that was most likely intended. */
public final class NearestName {

  private NearestName() {}

  /**
   * The candidate with the fewest differing letters, if they are few: two, or a third of the word.
   */
  static Optional<String> find(String written, Collection<String> candidates) {
    return candidates.stream()
        .min(Comparator.comparingInt(candidate -> distance(written, candidate)))
        .filter(nearest -> isNear(written, nearest));
  }

  static boolean isNear(String written, String candidate) {
    return distance(written, candidate) <= Math.max(2, candidate.length() / 3);
  }

  /** {@code ; did you mean "x"?}, or {@code otherwise} if no candidate is near. */
  public static String hint(String written, Collection<String> candidates, String otherwise) {
    return find(written, candidates)
        .map(nearest -> "; did you mean \"" + nearest + "\"?")
        .orElse(otherwise);
  }

  /** Levenshtein's distance: insertions, deletions and replacements of one letter. */
  private static int distance(String one, String other) {
    int[] row = new int[other.length() + 1];
    for (int j = 0; j < row.length; j++) {
      row[j] = j;
    }
    for (int i = 1; i <= one.length(); i++) {
      int diagonal = row[0];
      row[0] = i;
      for (int j = 1; j < row.length; j++) {
        int replaced = diagonal + (one.charAt(i - 1) == other.charAt(j - 1) ? 0 : 1);
        diagonal = row[j];
        row[j] = Math.min(replaced, 1 + Math.min(row[j], row[j - 1]));
      }
    }
    return row[row.length - 1];
  }
}
