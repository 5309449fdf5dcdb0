package org.dfra.cli.doctor;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dfra.cli.doctor.Finding.Verdict;
import org.dfra.report.terminal.TextWrap;
import org.dfra.text.PrintableText;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Help.Ansi;

/** Findings as lines of text output. */
final class FindingPrinter {

  private static final int VERDICT_WIDTH = 6;
  private static final int SUBJECT_WIDTH =
      Arrays.stream(Subject.values()).mapToInt(each -> each.id().length()).max().orElse(0) + 2;

  private static final int LABELS = VERDICT_WIDTH + SUBJECT_WIDTH;
  private static final String BLANK = " ".repeat(LABELS);

  private final Ansi ansi;
  private final int columns;

  /**
   * @param ansi whether the terminal has colours
   * @param columns maximum width of a line
   */
  FindingPrinter(Ansi ansi, int columns) {
    this.ansi = ansi;
    this.columns = columns;
  }

  List<String> of(List<Finding> findings) {
    List<String> lines = new ArrayList<>();
    for (Finding each : findings) {
      String line = verdict(each.verdict()) + padded(each.subject().id(), SUBJECT_WIDTH);
      for (String part : TextWrap.wrap(PrintableText.line(each.what()), columns - LABELS)) {
        lines.add(line + part);
        line = BLANK;
      }
      @Nullable String remedy = each.remedy();
      if (remedy != null) {
        lines.addAll(
            TextWrap.hangingIndent(BLANK + "→ " + PrintableText.line(remedy), columns, LABELS + 2));
      }
    }
    lines.add("");
    lines.add(summary(findings));
    return lines;
  }

  private String verdict(Verdict verdict) {
    String colour =
        switch (verdict) {
          case OK -> "green";
          case WARN -> "yellow";
          case FAIL -> "bold,red";
        };
    String padding = " ".repeat(VERDICT_WIDTH - verdict.name().length());
    return ansi.string("@|" + colour + " " + verdict + "|@") + padding;
  }

  private static String padded(String text, int width) {
    return text + " ".repeat(width - text.length());
  }

  private static String summary(List<Finding> findings) {
    long fails = count(findings, Verdict.FAIL);
    long warns = count(findings, Verdict.WARN);
    if (fails == 0 && warns == 0) {
      return "All is well.";
    }
    return (fails == 0 ? "Nothing fails" : counted(fails, "failure"))
        + (warns == 0 ? "" : ", " + counted(warns, "warning"))
        + ".";
  }

  private static String counted(long count, String what) {
    return count + " " + what + (count == 1 ? "" : "s");
  }

  private static long count(List<Finding> findings, Verdict verdict) {
    return findings.stream().filter(each -> each.verdict() == verdict).count();
  }
}
