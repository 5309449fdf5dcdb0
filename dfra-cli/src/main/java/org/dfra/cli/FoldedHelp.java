package org.dfra.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.report.terminal.Terminal;
import org.dfra.report.terminal.TextWrap;
import picocli.CommandLine.Help;
import picocli.CommandLine.Model.CommandSpec;

/**
 * The text that {@code --help} prints, as wide as the terminal but at most {@value #WIDEST}
 * columns. Picocli breaks each footer line separately, which leaves single words on lines of their
 * own. Here the footer's lines form paragraphs, and an indented line is a list entry; the following
 * lines continue its explanation.
 */
final class FoldedHelp extends Help {

  private static final int WIDEST = 80;
  private static final int NARROWEST = 55; // picocli rejects smaller widths

  /** A list entry's name and the spaces between the name and its explanation. */
  private static final Pattern NAME = Pattern.compile(" +\\S+ {2,}(?=\\S)");

  FoldedHelp(CommandSpec spec, ColorScheme scheme) {
    super(spec, scheme);
    spec.usageMessage().width(Width.HERE);
  }

  /**
   * The terminal width is determined once, and only when help is printed: each subcommand has its
   * own help.
   */
  private static final class Width {
    static final int HERE = width(Terminal.columns());
  }

  static int width(int columns) {
    return Math.max(NARROWEST, Math.min(WIDEST, columns));
  }

  @Override
  public String footer(Object... arguments) {
    int width = commandSpec().usageMessage().width();
    String[] lines = commandSpec().usageMessage().footer();
    StringBuilder text = new StringBuilder();
    folded(List.of(lines), width - 1)
        .forEach(line -> text.append(line).append(System.lineSeparator()));
    return text.toString();
  }

  /**
   * Wraps paragraphs and lists at the given number of columns; a blank line separates paragraphs.
   */
  static List<String> folded(List<String> lines, int columns) {
    List<String> folded = new ArrayList<>();
    StringBuilder paragraph = new StringBuilder();
    for (String line : lines) {
      boolean isText = !line.isBlank() && !line.startsWith(" ");
      if (isText) {
        paragraph.append(paragraph.isEmpty() ? "" : " ").append(line);
        continue;
      }
      end(paragraph, columns, folded);
      Matcher name = NAME.matcher(line);
      folded.addAll(
          TextWrap.hangingIndent(line, columns, name.lookingAt() ? name.end() : margin(line) + 2));
    }
    end(paragraph, columns, folded);
    return folded;
  }

  private static void end(StringBuilder paragraph, int columns, List<String> folded) {
    if (!paragraph.isEmpty()) {
      folded.addAll(TextWrap.wrap(paragraph.toString(), columns));
      paragraph.setLength(0);
    }
  }

  private static int margin(String line) {
    return line.length() - line.stripLeading().length();
  }
}
