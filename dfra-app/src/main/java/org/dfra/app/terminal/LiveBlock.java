package org.dfra.app.terminal;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/**
 * Lines at the bottom of a terminal that are drawn anew in place, while other text scrolls above
 * them. It writes nothing itself: what its methods return is to be printed, at once and in order.
 *
 * <p>The cursor always rests below the last line and stays visible, and each piece of text leaves
 * the terminal as it was: so there is nothing to restore, also where the process is killed.
 *
 * <p>Not safe for use by several threads.
 */
public final class LiveBlock {

  private static final String DISABLE_WRAP = "\u001b[?7l"; // no going on in the next line
  private static final String ENABLE_WRAP = "\u001b[?7h";
  private static final String MORE = "…";

  private final Supplier<Terminal.Size> size;
  private List<String> lines = List.of(); // as they are to be shown
  private List<String> drawn = List.of(); // lines that are there now

  /**
   * @param size of the terminal, asked for at each drawing
   */
  public LiveBlock(Supplier<Terminal.Size> size) {
    this.size = size;
  }

  /** What draws these lines in place of the last ones. */
  public String draw(List<String> fresh) {
    lines = List.copyOf(fresh);
    return erased() + shown();
  }

  /**
   * What writes text above the block.
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

  /** What is drawn stays for good; what comes next comes below. */
  public void freeze() {
    lines = List.of();
    drawn = List.of();
  }

  /**
   * Goes up over what was drawn and clears it. A terminal that was made narrower has folded lines
   * that do not fit any more, so they take more of its rows than they did.
   */
  private String erased() {
    int columns = size.get().columns();
    long rows = 0;
    for (String line : drawn) {
      rows += Math.max(1, (TextWrap.width(line) + (long) columns - 1) / columns);
    }
    return rows == 0 ? "" : "\u001b[" + rows + "A\u001b[J";
  }

  /** No more than the terminal has room for: what has scrolled off cannot be drawn anew. */
  private String shown() {
    Terminal.Size room = size.get();
    List<String> fitting = new ArrayList<>();
    for (String line : lines.subList(0, Math.min(lines.size(), Math.max(1, room.rows() - 1)))) {
      fitting.add(cut(line, room.columns()));
    }
    drawn = List.copyOf(fitting);
    if (fitting.isEmpty()) {
      return "";
    }
    String end = System.lineSeparator();
    return DISABLE_WRAP + String.join(end, fitting) + end + ENABLE_WRAP;
  }

  /**
   * A line that is no wider than so many columns; where something is left out, an ellipsis stands
   * for it. Each character is taken to be one column wide.
   */
  public static String cut(String line, int columns) {
    String text = line.stripTrailing();
    if (TextWrap.width(text) <= columns) {
      return text;
    }
    return text.substring(0, text.offsetByCodePoints(0, columns - 1)) + MORE;
  }
}
