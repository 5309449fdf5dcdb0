package org.dfra.app.demo.stage;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.function.LongSupplier;
import java.util.regex.Pattern;
import org.dfra.app.figure.Figure;
import org.dfra.app.figure.Figures;

/** What a demonstration says, each sentence with the time since it began, and what it measured. */
public final class Narration {

  private static final int WIDTH = 96;

  /** Where a line may end: not between a number and its unit. */
  private static final Pattern BREAK = Pattern.compile(" (?!(?:s|ms|µs|ns|Hz|m)\\b|%)");

  private static final String INDENT = " ".repeat(11);

  /** Tables are wider than sentences, so they begin further left. */
  private static final String MARGIN = " ".repeat(4);

  private final PrintWriter out;
  private final LongSupplier nanos;
  private final boolean isTerminal;
  private final long began;
  private final Figures figures = new Figures();
  private String step = "setting the stage";
  private boolean spaced; // the last line was empty
  private int redrawn; // lines at the end that are shown for now only

  /**
   * @param nanos a clock that only differences are taken of, in nanoseconds
   */
  public Narration(PrintWriter out, LongSupplier nanos) {
    this(out, nanos, false);
  }

  /**
   * @param nanos a clock that only differences are taken of, in nanoseconds
   * @param isTerminal whether lines that were written can be written anew
   */
  public Narration(PrintWriter out, LongSupplier nanos, boolean isTerminal) {
    this.isTerminal = isTerminal;
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

  /**
   * Shows lines in place of those that were shown so before; the last ones stay. What is too wide
   * for the terminal is cut there.
   */
  public void redraw(List<String> lines) {
    String up = redrawn == 0 ? "" : "\u001b[" + redrawn + "A\u001b[J";
    out.print(up + "\u001b[?7l"); // no going on in the next line
    lines.forEach(line -> out.println((MARGIN + line).stripTrailing()));
    out.print("\u001b[?7h");
    redrawn = lines.size();
    spaced = false;
    out.flush();
  }

  /** A heading. */
  public void heading(String title) {
    blank();
    out.println(title);
    redrawn = 0;
    spaced = false;
    out.flush();
  }

  /** A sentence; the format is {@link String#format}'s. */
  public void say(String format, Object... arguments) {
    String text = String.format(Locale.ROOT, format, arguments);
    StringBuilder line = new StringBuilder(String.format(Locale.ROOT, "%8.3f s ", elapsed() / 1e9));
    int column = line.length();
    for (String word : BREAK.split(text)) {
      if (column + word.length() + 1 > WIDTH && column > INDENT.length()) {
        line.append(System.lineSeparator()).append(INDENT);
        column = INDENT.length();
      } else {
        line.append(' ');
        column++;
      }
      line.append(word);
      column += word.length();
    }
    out.println(line);
    redrawn = 0;
    spaced = false;
    out.flush();
  }

  /** Lines under a sentence, as they are, such as those of a table, with a blank one after. */
  public void show(List<String> lines) {
    lines.forEach(line -> out.println((MARGIN + line).stripTrailing()));
    redrawn = 0;
    spaced = false;
    blank();
    out.flush();
  }

  /** An empty line, unless the last one was. */
  public void blank() {
    if (!spaced) {
      out.println();
      redrawn = 0;
      spaced = true;
    }
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
    figures.add(new Figure(what, measured, limit, unit));
  }

  /** Notes a duration in seconds. */
  public void figure(String what, Duration measured, Duration limit) {
    figure(what, measured.toNanos() / 1e9, limit.toNanos() / 1e9, "s");
  }

  /** What was measured until now. */
  public Figures figures() {
    return figures;
  }

  /** Prints the table of figures. */
  public void table() {
    heading("Measured");
    figures.all().forEach(each -> out.println(each.line()));
    out.flush();
  }

  private long elapsed() {
    return nanos.getAsLong() - began;
  }
}
