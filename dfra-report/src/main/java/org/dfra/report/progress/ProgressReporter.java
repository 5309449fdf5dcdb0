package org.dfra.report.progress;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.PrintWriter;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.measurement.RunMeasurements;
import org.dfra.report.terminal.LiveBlock;
import org.dfra.report.terminal.StatusHighlighter;
import org.dfra.report.terminal.Table;
import org.dfra.report.terminal.Terminal;
import org.dfra.report.terminal.TextWrap;
import org.dfra.text.PrintableText;

/**
 * Reports the progress of a demonstration, each sentence with the time since the start, and its
 * measurements. Thread-safe.
 *
 * <p>On a terminal, live lines at the end can be redrawn, {@link #redraw}, while other text is
 * printed above them, until {@link #freezeLive} makes them permanent.
 */
public final class ProgressReporter {

  private static final int WIDTH = 96;
  private static final int NARROWEST = 40;

  private static final String INDENT = " ".repeat(11);

  /** Tables are wider than sentences, so their margin is smaller. */
  private static final String MARGIN = " ".repeat(4);

  /** The live block is wide too, and indented to differ from the scrolling text. */
  private static final String BLOCK_MARGIN = " ";

  private static final String END = System.lineSeparator();

  /** Columns of a table without a terminal. */
  private static final int TABLE = Terminal.Size.DEFAULT.columns();

  private final PrintWriter out;
  private final boolean isColoured;
  private final LongSupplier nanos;
  private final boolean isTerminal;

  @GuardedBy("this")
  private final Supplier<Terminal.Size> size;

  @GuardedBy("this")
  private final LiveBlock block;

  private final long began;
  private final RunMeasurements figures = new RunMeasurements();
  private volatile String step = "setting the stage";

  // the last line was empty
  @GuardedBy("this")
  private boolean spaced;

  /**
   * @param nanos a monotonic clock with any origin, in nanoseconds
   */
  public ProgressReporter(PrintWriter out, LongSupplier nanos) {
    this(out, nanos, false);
  }

  /**
   * @param nanos a monotonic clock with any origin, in nanoseconds
   * @param isTerminal whether printed lines can be redrawn
   */
  public ProgressReporter(PrintWriter out, LongSupplier nanos, boolean isTerminal) {
    this(out, nanos, isTerminal, () -> Terminal.Size.UNLIMITED);
  }

  /**
   * @param nanos a monotonic clock with any origin, in nanoseconds
   * @param isTerminal whether printed lines can be redrawn
   * @param size of the terminal, also if lines cannot be redrawn; sentences are wrapped and live
   *     lines are cut at its width
   */
  public ProgressReporter(
      PrintWriter out, LongSupplier nanos, boolean isTerminal, Supplier<Terminal.Size> size) {
    this(out, nanos, isTerminal, size, false);
  }

  /**
   * @param isColoured whether {@code FAILED} and the like are coloured; only if {@linkplain
   *     StatusHighlighter#isEnabled colour is enabled}
   */
  ProgressReporter(
      PrintWriter out,
      LongSupplier nanos,
      boolean isTerminal,
      Supplier<Terminal.Size> size,
      boolean isColoured) {
    this.isColoured = isColoured;
    this.isTerminal = isTerminal;
    this.size = size;
    this.block = new LiveBlock(size);
    this.out = out;
    this.nanos = nanos;
    this.began = nanos.getAsLong();
  }

  /** Begins a step with a heading of its own. */
  public void section(String doing, String title) {
    step(doing);
    heading(title);
  }

  /** Starts a step within a chapter; a failure report names it. */
  public void step(String doing) {
    step = doing;
  }

  /** The current step, such as "killing phoenix". */
  public String step() {
    return step;
  }

  /** Whether printed lines can be redrawn by {@link #redraw}. */
  public boolean isTerminal() {
    return isTerminal;
  }

  /** Reports to the user who started this process, on the terminal if there is one. */
  public static ProgressReporter to(PrintWriter out) {
    Supplier<Terminal.Size> size =
        Terminal.isTerminal() ? new Terminal() : () -> Terminal.Size.UNLIMITED;
    return new ProgressReporter(
        out, System::nanoTime, Terminal.canRedraw(), size, StatusHighlighter.isEnabled());
  }

  /**
   * Shows live lines at the end, in place of the previous ones. Other text is printed above them.
   * Lines are cut at the width of the terminal.
   */
  public synchronized void redraw(List<String> lines) {
    out.print(
        block.draw(lines.stream().map(line -> BLOCK_MARGIN + PrintableText.line(line)).toList()));
    out.flush();
  }

  /** Makes the live lines permanent; further text is printed below. */
  public synchronized void freezeLive() {
    if (block.isDrawn()) {
      block.freeze();
      spaced = false;
    }
  }

  /** A heading. */
  public synchronized void heading(String title) {
    blank();
    for (String line : TextWrap.wrapBreakingLongWords(printable(title), width(), width())) {
      print(coloured(line) + END);
    }
  }

  /** A sentence; format as in {@link String#format}. */
  public synchronized void say(String format, Object... arguments) {
    String time = String.format(Locale.ROOT, "%8.3f s  ", elapsed() / 1e9);
    int columns = width() - INDENT.length();
    List<String> lines =
        TextWrap.wrapBreakingLongWords(
            printable(String.format(Locale.ROOT, format, arguments)),
            width() - time.length(),
            columns);
    print(time + String.join(END + INDENT, lines) + END);
  }

  @GuardedBy("this")
  private int width() {
    return Math.max(NARROWEST, Math.min(WIDTH, size.get().columns()));
  }

  /** A table under a sentence, no wider than the terminal, with a blank line after. */
  public void show(Table table) {
    show(table.lines(columns() - MARGIN.length()));
  }

  /** Maximum width of a table; a terminal without colours has a width, too. */
  public synchronized int columns() {
    int columns = size.get().columns();
    return isTerminal || columns < Terminal.Size.UNLIMITED.columns() ? columns : TABLE;
  }

  /** Unformatted lines under a sentence, such as those of a table, with a blank line after. */
  public synchronized void show(List<String> lines) {
    StringBuilder text = new StringBuilder();
    lines.forEach(
        line ->
            text.append((MARGIN + coloured(PrintableText.line(line))).stripTrailing()).append(END));
    print(text.toString());
    blank();
  }

  /** A sentence without the time, below a blank line. */
  public synchronized void remark(String text) {
    blank();
    int columns = Math.min(WIDTH, columns()) - 2;
    for (String line : TextWrap.wrapBreakingLongWords(printable(text), columns, columns)) {
      print("  " + coloured(line) + END);
    }
  }

  /** A sentence; its source may have several lines. */
  private static String printable(String text) {
    return PrintableText.line(text.strip().replaceAll("[ \\t]*\\R[ \\t]*", " "));
  }

  private String coloured(String line) {
    return isColoured ? StatusHighlighter.highlight(line) : line;
  }

  /** A blank line, unless the last line was blank. */
  public synchronized void blank() {
    if (!spaced) {
      print(END);
      spaced = true;
    }
  }

  /** Writes complete lines in one call. */
  @GuardedBy("this")
  private void print(String text) {
    out.print(block.printAbove(text));
    out.flush();
    spaced = false;
  }

  /** Starts a stopwatch. */
  public Stopwatch stopwatch() {
    long start = nanos.getAsLong();
    return () -> Duration.ofNanos(nanos.getAsLong() - start);
  }

  /** A running measurement. */
  public interface Stopwatch {
    Duration elapsed();
  }

  /** Records a value for the table at the end. */
  public void figure(String what, double measured, double limit, String unit) {
    figures.add(new MeasuredValue(what, measured, limit, unit));
  }

  /** Records a duration in seconds. */
  public void figure(String what, Duration measured, Duration limit) {
    figure(what, measured.toNanos() / 1e9, limit.toNanos() / 1e9, "s");
  }

  /**
   * Records a time limit that applies on every computer, such as the time in which a robot stops.
   */
  public void requirement(String what, Duration measured, Duration limit) {
    figures.add(
        new MeasuredValue(what, measured.toNanos() / 1e9, limit.toNanos() / 1e9, "s").asRequired());
  }

  /** The measurements so far. */
  public RunMeasurements figures() {
    return figures;
  }

  /** Prints the table of measurements. */
  public synchronized void table() {
    heading("Measured");
    for (MeasuredValue each : figures.all()) {
      for (String line : each.lines(columns())) {
        print(coloured(line) + END);
      }
    }
  }

  private long elapsed() {
    return nanos.getAsLong() - began;
  }
}
