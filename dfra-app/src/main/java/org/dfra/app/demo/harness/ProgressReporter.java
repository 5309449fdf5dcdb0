package org.dfra.app.demo.harness;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.dfra.app.measurement.MeasuredValue;
import org.dfra.app.measurement.RunMeasurements;
import org.dfra.app.terminal.LiveBlock;
import org.dfra.app.terminal.StatusHighlighter;
import org.dfra.app.terminal.Table;
import org.dfra.app.terminal.Terminal;
import org.dfra.app.terminal.TextWrap;
import org.dfra.text.PrintableText;

/**
 * What a demonstration says, each sentence with the time since it began, and what it measured. Safe
 * for use by several threads.
 *
 * <p>On a terminal, lines at the end can be drawn anew, {@link #redraw}, while all else is written
 * above them, until they are to stay as they are, {@link #freezeLive}.
 */
public final class ProgressReporter {

  private static final int WIDTH = 96;
  private static final int NARROWEST = 40;

  private static final String INDENT = " ".repeat(11);

  /** Tables are wider than sentences, so they begin further left. */
  private static final String MARGIN = " ".repeat(4);

  /** What is drawn anew is wide too, and set off from what scrolls. */
  private static final String BLOCK_MARGIN = " ";

  private static final String END = System.lineSeparator();

  /** Columns of a table where there is no terminal. */
  private static final int TABLE = Terminal.Size.DEFAULT.columns();

  private final PrintWriter out;
  private final boolean isColoured;
  private final LongSupplier nanos;
  private final boolean isTerminal;
  private final Supplier<Terminal.Size> size; // guarded by this
  private final LiveBlock block; // guarded by this
  private final long began;
  private final RunMeasurements figures = new RunMeasurements();
  private volatile String step = "setting the stage";
  private boolean spaced; // the last line was empty; guarded by this

  /**
   * @param nanos a clock that only differences are taken of, in nanoseconds
   */
  public ProgressReporter(PrintWriter out, LongSupplier nanos) {
    this(out, nanos, false);
  }

  /**
   * @param nanos a clock that only differences are taken of, in nanoseconds
   * @param isTerminal whether lines that were written can be written anew
   */
  public ProgressReporter(PrintWriter out, LongSupplier nanos, boolean isTerminal) {
    this(out, nanos, isTerminal, () -> Terminal.Size.UNLIMITED);
  }

  /**
   * @param nanos a clock that only differences are taken of, in nanoseconds
   * @param isTerminal whether lines that were written can be written anew
   * @param size of the terminal, also where nothing can be written anew; sentences are broken and
   *     lines that are drawn anew are cut there
   */
  public ProgressReporter(
      PrintWriter out, LongSupplier nanos, boolean isTerminal, Supplier<Terminal.Size> size) {
    this(out, nanos, isTerminal, size, false);
  }

  /**
   * @param isColoured whether {@code FAILED} and the like have colours; only where it {@linkplain
   *     StatusHighlighter#isEnabled is wanted}
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
  public void chapter(String doing, String title) {
    step(doing);
    heading(title);
  }

  /** Begins a step within a chapter, so that it can be named should it fail. */
  public void step(String doing) {
    step = doing;
  }

  /** What is being done, such as "killing phoenix". */
  public String step() {
    return step;
  }

  /** Whether lines that were written can be written anew: {@link #redraw} does. */
  public boolean isTerminal() {
    return isTerminal;
  }

  /** What speaks to whoever has started this process, in the terminal if there is one. */
  public static ProgressReporter to(PrintWriter out) {
    Supplier<Terminal.Size> size =
        Terminal.isTerminal() ? new Terminal() : () -> Terminal.Size.UNLIMITED;
    return new ProgressReporter(
        out, System::nanoTime, Terminal.canRedraw(), size, StatusHighlighter.isEnabled());
  }

  /**
   * Shows lines at the end, in place of those that were shown so before. What is said meanwhile is
   * written above them. What is too wide for the terminal is cut there.
   */
  public synchronized void redraw(List<String> lines) {
    out.print(
        block.draw(lines.stream().map(line -> BLOCK_MARGIN + PrintableText.line(line)).toList()));
    out.flush();
  }

  /** What was drawn last stays; what is said from here on comes below. */
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

  /** A sentence; the format is {@link String#format}'s. */
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

  private int width() {
    return Math.max(NARROWEST, Math.min(WIDTH, size.get().columns()));
  }

  /** A table under a sentence, no wider than the terminal, with a blank line after. */
  public void show(Table table) {
    show(table.lines(columns() - MARGIN.length()));
  }

  /** How wide a table may be; a terminal without colours has a width, too. */
  public int columns() {
    int columns = size.get().columns();
    return isTerminal || columns < Terminal.Size.UNLIMITED.columns() ? columns : TABLE;
  }

  /** Lines under a sentence, as they are, such as those of a table, with a blank one after. */
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

  /** A sentence; it may have been written in several lines. */
  private static String printable(String text) {
    return PrintableText.line(text.strip().replaceAll("[ \\t]*\\R[ \\t]*", " "));
  }

  private String coloured(String line) {
    return isColoured ? StatusHighlighter.highlight(line) : line;
  }

  /** An empty line, unless the last one was. */
  public synchronized void blank() {
    if (!spaced) {
      print(END);
      spaced = true;
    }
  }

  /** Writes whole lines, in one piece. */
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

  /** Notes a figure for the table at the end. */
  public void figure(String what, double measured, double limit, String unit) {
    figures.add(new MeasuredValue(what, measured, limit, unit));
  }

  /** Notes a duration in seconds. */
  public void figure(String what, Duration measured, Duration limit) {
    figure(what, measured.toNanos() / 1e9, limit.toNanos() / 1e9, "s");
  }

  /** Notes a time that must be kept on every computer, such as that in which a robot stops. */
  public void requirement(String what, Duration measured, Duration limit) {
    figures.add(
        new MeasuredValue(what, measured.toNanos() / 1e9, limit.toNanos() / 1e9, "s").asRequired());
  }

  /** What was measured until now. */
  public RunMeasurements figures() {
    return figures;
  }

  /** Prints the table of figures. */
  public synchronized void table() {
    heading("Measured");
    for (MeasuredValue each : figures.all()) {
      each.lines(columns()).forEach(line -> print(coloured(line) + END));
    }
  }

  private long elapsed() {
    return nanos.getAsLong() - began;
  }
}
