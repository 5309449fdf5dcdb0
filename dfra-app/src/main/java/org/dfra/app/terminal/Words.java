package org.dfra.app.terminal;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/** Text in columns. Each character is taken to be one column wide. */
public final class Words {

  /**
   * Where a line may end: not between a number and its unit, and not within what is typed. Half of
   * {@code ./dfra stop --release atrv1}, copied from one line, would release every robot.
   */
  public static final Pattern BREAK =
      Pattern.compile(
          "(?<!\\./dfra)(?<!\\./dfra [a-z]{1,12})(?<! --[a-z-]{1,16})(?<!\\bEMERGENCY)"
              + " (?!(?:s|ms|µs|ns|Hz|m|°)\\b|%|--[a-z]|(?<=\\d )(?:[kMG]B|W|V|rad)\\b)");

  /** What a line has at least, however far it begins to the right. */
  private static final int NARROWEST = 20;

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

  /**
   * A line broken at blanks; what does not fit goes on below, further to the right than the line
   * begins.
   *
   * @param columns most of a line
   * @param indent where the lines below begin; less where so few columns would be left
   */
  public static List<String> hanging(String line, int columns, int indent) {
    if (width(line) <= columns) {
      return List.of(line);
    }
    int margin = line.length() - line.stripLeading().length();
    String below = " ".repeat(Math.max(0, Math.min(indent, columns - NARROWEST)));
    String begin = line.substring(0, margin);
    List<String> lines = new ArrayList<>();
    StringBuilder text = new StringBuilder();
    for (String word : BREAK.split(line.substring(margin), -1)) {
      if (!text.isEmpty() && width(begin + text + " " + word) > columns) {
        lines.add(begin + text);
        text.setLength(0);
        begin = below;
      }
      text.append(text.isEmpty() ? "" : " ").append(word);
    }
    lines.add(begin + text);
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
