package org.dfra.app.demo;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.LongSupplier;

/** What a demonstration says, each sentence with the time since it began, and what it measured. */
final class Narration {

  private static final int WIDTH = 96;
  private static final String INDENT = " ".repeat(11);

  private final PrintWriter out;
  private final LongSupplier nanos;
  private final long began;
  private final List<Figure> figures = new ArrayList<>();

  /**
   * One measured figure.
   *
   * @param what what was measured
   * @param measured the value
   * @param limit the most it should be
   * @param unit the unit of both
   */
  record Figure(String what, double measured, double limit, String unit) {
    boolean isMet() {
      return measured <= limit;
    }
  }

  /**
   * @param nanos a clock that only differences are taken of, in nanoseconds
   */
  Narration(PrintWriter out, LongSupplier nanos) {
    this.out = out;
    this.nanos = nanos;
    this.began = nanos.getAsLong();
  }

  /** A heading. */
  void chapter(String title) {
    out.println();
    out.println(title);
    out.flush();
  }

  /** A sentence; the format is {@link String#format}'s. */
  void say(String format, Object... arguments) {
    String text = String.format(Locale.ROOT, format, arguments);
    StringBuilder line = new StringBuilder(String.format(Locale.ROOT, "%8.3f s ", elapsed() / 1e9));
    int column = line.length();
    for (String word : text.split(" ", -1)) {
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
    out.flush();
  }

  /** Starts a stopwatch. */
  Stopwatch stopwatch() {
    long start = nanos.getAsLong();
    return () -> Duration.ofNanos(nanos.getAsLong() - start);
  }

  /** A running measurement. */
  interface Stopwatch {
    Duration elapsed();
  }

  /** Notes a figure for the table at the end. */
  void figure(String what, double measured, double limit, String unit) {
    figures.add(new Figure(what, measured, limit, unit));
  }

  /** Notes a duration in seconds. */
  void figure(String what, Duration measured, Duration limit) {
    figure(what, measured.toNanos() / 1e9, limit.toNanos() / 1e9, "s");
  }

  /** Prints the table of figures. */
  void table() {
    chapter("Measured");
    for (Figure figure : figures) {
      out.printf(
          Locale.ROOT,
          "  %-58s %9s %-2s   wanted ≤ %s %s%s%n",
          figure.what(),
          number(figure.measured()),
          figure.unit(),
          number(figure.limit()),
          figure.unit(),
          figure.isMet() ? "" : "   MISSED");
    }
    out.flush();
  }

  /** Appends the figures to a CSV file, which is begun with a header where it does not exist. */
  void record(Path file, String demo) throws IOException {
    StringBuilder rows = new StringBuilder();
    if (!Files.exists(file)) {
      rows.append("when,demo,java,cores,figure,measured,wanted_at_most,unit\n");
    }
    Instant now = Instant.now().truncatedTo(ChronoUnit.SECONDS);
    for (Figure figure : figures) {
      rows.append(
          String.format(
              Locale.ROOT,
              "%s,%s,%s,%d,\"%s\",%s,%s,%s%n",
              now,
              demo,
              Runtime.version().feature(),
              Runtime.getRuntime().availableProcessors(),
              figure.what(),
              number(figure.measured()),
              number(figure.limit()),
              figure.unit()));
    }
    Files.writeString(file, rows, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
  }

  private static String number(double value) {
    return value >= 100
        ? String.format(Locale.ROOT, "%.0f", value)
        : String.format(Locale.ROOT, value == Math.rint(value) ? "%.0f" : "%.3f", value);
  }

  private long elapsed() {
    return nanos.getAsLong() - began;
  }
}
