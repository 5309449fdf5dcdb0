package org.dfra.report.terminal;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Help.Ansi;

/**
 * Colours status words: good ones green, bad ones red. A line is coloured after its layout, since
 * escape codes take no columns. In {@code stale: no} the word is a name.
 */
public final class StatusHighlighter {

  private static final Pattern WORDS =
      Pattern.compile(
          "\\b(?:(READY|ready|MET)"
              + "|(FAILED|failed|MISSED|STALE|stale(?!:)|CRASHED|EMERGENCY STOP|HELD))\\b");
  private static final String GREEN = "\u001b[32m";
  private static final String RED = "\u001b[31m";
  private static final String BOLD = "\u001b[1m";
  private static final String PLAIN = "\u001b[0m";

  private StatusHighlighter() {}

  /**
   * Whether this process may print colours: only to a terminal, and not if {@code NO_COLOR} is set
   * or the terminal is {@code dumb}.
   */
  public static boolean isEnabled() {
    return isEnabled(Ansi.AUTO.enabled(), System.getenv("NO_COLOR"), System.getenv("TERM"));
  }

  static boolean isEnabled(boolean isTerminal, @Nullable String noColor, @Nullable String term) {
    return isTerminal && (noColor == null || noColor.isEmpty()) && !"dumb".equals(term);
  }

  /** The line with its status words coloured. */
  public static String highlight(String line) {
    Matcher word = WORDS.matcher(line);
    return word.replaceAll(found -> (found.group(1) != null ? GREEN : RED) + found.group() + PLAIN);
  }

  /** The line, emphasised. */
  public static String bold(String line) {
    return BOLD + line + PLAIN;
  }
}
