package org.dfra.app.terminal;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/** Text in columns. Each character is taken to be one column wide. */
public final class Words {

  /** Where a line may end: not between a number and its unit. */
  public static final Pattern BREAK = Pattern.compile(" (?!(?:s|ms|µs|ns|Hz|m|°)\\b|%)");

  private Words() {}

  /** Columns that a text takes. */
  public static int width(String text) {
    return text.codePointCount(0, text.length());
  }

  /** A text with blanks behind it, so many columns wide or wider. */
  public static String padded(String text, int columns) {
    return text + " ".repeat(Math.max(0, columns - width(text)));
  }

  /**
   * A text broken at blanks. A word is never broken, so that it can be copied: one that is longer
   * has a line for itself.
   *
   * @param columns most of a line
   */
  public static List<String> folded(String text, int columns) {
    if (width(text) <= columns) {
      return List.of(text);
    }
    List<String> lines = new ArrayList<>();
    StringBuilder line = new StringBuilder();
    for (String word : BREAK.split(text, -1)) {
      if (!line.isEmpty() && width(line + " " + word) > columns) {
        lines.add(line.toString());
        line.setLength(0);
      }
      line.append(line.isEmpty() ? "" : " ").append(word);
    }
    lines.add(line.toString());
    return lines;
  }

  /** Columns of the longest word. */
  static int longestWord(String text) {
    int longest = 0;
    for (String word : BREAK.split(text, -1)) {
      longest = Math.max(longest, width(word));
    }
    return longest;
  }
}
