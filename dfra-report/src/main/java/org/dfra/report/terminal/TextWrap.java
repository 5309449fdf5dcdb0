package org.dfra.report.terminal;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;

/** Text in columns. Each character is assumed to be one column wide. */
public final class TextWrap {

  /**
   * Possible line breaks: not between a number and its unit, and not within commands. Half of
   * {@code ./dfra stop --release atrv1}, copied from one line, would release every robot.
   */
  public static final Pattern BREAK =
      Pattern.compile(
          "(?<!\\bdfra)(?<!\\bdfra [a-z]{1,12})(?<! --[a-z-]{1,16})(?<!\\bEMERGENCY)"
              + " (?!(?:s|ms|µs|ns|Hz|m|°)\\b|%|--[a-z]|(?<=\\d )(?:[kMG]B|W|V|rad)\\b)");

  /** Minimum width of a line, however far it is indented. */
  private static final int NARROWEST = 20;

  /** A file path, perhaps in quotation marks. */
  private static final Pattern PATH = Pattern.compile("^[\"'(]?(?:\\.{0,2}/|~/)");

  /** A word that is longer than a line may be broken after these. */
  private static final String BREAK_AFTER = "/\\[](){},;:=@&|.-_$";

  private TextWrap() {}

  /** Columns that a text takes. */
  public static int width(CharSequence text) {
    return Character.codePointCount(text, 0, text.length());
  }

  /** A text padded with blanks to at least these columns. */
  public static String padded(String text, int columns) {
    return text + " ".repeat(Math.max(0, columns - width(text)));
  }

  /**
   * A text wrapped at blanks. A word is never broken, so that it can be copied: a longer word has a
   * line for itself.
   *
   * @param columns maximum width of a line
   */
  public static List<String> wrap(String text, int columns) {
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
   * A sentence wrapped at blanks, with no wider line: longer words, such as the endpoints in the
   * message of a failed call, are broken too. A file path is not, so that it can be copied.
   *
   * @param first columns of the first line
   * @param columns of all others, 1 or more
   */
  public static List<String> wrapBreakingLongWords(String text, int first, int columns) {
    List<String> lines = new ArrayList<>();
    StringBuilder line = new StringBuilder();
    for (String word : BREAK.split(text.strip().replaceAll("\\s+", " "), -1)) {
      for (String piece : pieces(word, columns)) {
        boolean isRest = !piece.equals(word) && !word.startsWith(piece);
        int available = lines.isEmpty() ? first : columns;
        int needed = line.isEmpty() ? width(piece) : width(line) + 1 + width(piece);
        if (isRest || (needed > available && !line.isEmpty())) {
          lines.add(line.toString());
          line.setLength(0);
        }
        line.append(line.isEmpty() ? "" : " ").append(piece);
      }
    }
    lines.add(line.toString());
    return lines;
  }

  /** Ends after a punctuation mark if there is one in its second half. */
  private static List<String> pieces(String word, int columns) {
    if (PATH.matcher(word).find()) {
      return List.of(word);
    }
    List<String> pieces = new ArrayList<>();
    int[] rest = word.codePoints().toArray();
    while (rest.length > columns) {
      int end = columns;
      for (int at = columns; at > columns / 2; at--) {
        if (BREAK_AFTER.indexOf(rest[at - 1]) >= 0) {
          end = at;
          break;
        }
      }
      pieces.add(new String(rest, 0, end));
      rest = Arrays.copyOfRange(rest, end, rest.length);
    }
    pieces.add(new String(rest, 0, rest.length));
    return pieces;
  }

  /**
   * A line wrapped at blanks, with a hanging indent.
   *
   * @param columns maximum width of a line
   * @param indent of the continuation lines; less if too few columns would be left
   */
  public static List<String> hangingIndent(String line, int columns, int indent) {
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
