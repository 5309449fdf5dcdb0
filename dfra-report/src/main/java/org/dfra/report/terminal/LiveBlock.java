package org.dfra.report.terminal;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/**
 * Lines at the bottom of a terminal that are redrawn in place, while other text scrolls above them.
 * It prints nothing itself: the caller must print the results of its methods immediately and in
 * order.
 *
 * <p>The cursor always stays below the last line and visible, and each piece of text leaves the
 * terminal's modes unchanged: nothing has to be restored, even if the process is killed.
 *
 * <p>Not thread-safe.
 */
public final class LiveBlock {

  private static final String DISABLE_WRAP = "\u001b[?7l"; // disables line wrapping
  private static final String ENABLE_WRAP = "\u001b[?7h";
  private static final String MORE = "…";

  private final Supplier<Terminal.Size> size;
  private List<String> lines = List.of(); // the lines to be shown
  private List<String> drawn = List.of(); // number of lines currently drawn

  /**
   * @param size of the terminal, queried at each drawing
   */
  public LiveBlock(Supplier<Terminal.Size> size) {
    this.size = size;
  }

  /** The output that draws these lines in place of the last ones. */
  public String draw(List<String> fresh) {
    lines = List.copyOf(fresh);
    return erased() + shown();
  }

  /**
   * The output that prints text above the block.
   *
   * @param text whole lines, each with its end
   */
  public String printAbove(String text) {
    return drawn.isEmpty() ? text : erased() + text + shown();
  }

  /** Whether anything is drawn. */
  public boolean isDrawn() {
    return !drawn.isEmpty();
  }

  /** Makes the drawn lines permanent; further output is printed below. */
  public void freeze() {
    lines = List.of();
    drawn = List.of();
  }

  /**
   * Moves the cursor up over the drawn lines and clears them. A terminal that has become narrower
   * has wrapped long lines, so they take more rows than before.
   */
  private String erased() {
    int columns = size.get().columns();
    long rows = 0;
    for (String line : drawn) {
      rows += Math.max(1, (TextWrap.width(line) + (long) columns - 1) / columns);
    }
    return rows == 0 ? "" : "\u001b[" + rows + "A\u001b[J";
  }

  /** At most as many lines as the terminal has: lines that have scrolled off cannot be redrawn. */
  private String shown() {
    Terminal.Size available = size.get();
    List<String> fitting = new ArrayList<>();
    for (String line :
        lines.subList(0, Math.min(lines.size(), Math.max(1, available.rows() - 1)))) {
      fitting.add(cut(line, available.columns()));
    }
    drawn = List.copyOf(fitting);
    if (fitting.isEmpty()) {
      return "";
    }
    String end = System.lineSeparator();
    return DISABLE_WRAP + String.join(end, fitting) + end + ENABLE_WRAP;
  }

  /**
   * A line cut at these columns; an ellipsis replaces the omitted text. Each character is assumed
   * to be one column wide.
   */
  public static String cut(String line, int columns) {
    String text = line.stripTrailing();
    if (TextWrap.width(text) <= columns) {
      return text;
    }
    return text.substring(0, text.offsetByCodePoints(0, columns - 1)) + MORE;
  }
}
