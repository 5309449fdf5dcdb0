package org.dfra.report.terminal;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Help.Ansi;

/**
 * The terminal that this process writes to. Its size is queried again every {@value #MILLIS} ms,
 * since users resize windows. Not thread-safe.
 */
public final class Terminal implements Supplier<Terminal.Size> {

  private static final int MILLIS = 150; // redrawing with a wrong size leaves artefacts
  private static final long STTY_TIMEOUT_MILLIS = 500;
  private static final Pattern STTY = Pattern.compile("\\s*(\\d{1,5})\\s+(\\d{1,5})\\s*");

  /**
   * Its size.
   *
   * @param columns characters in a line
   * @param rows lines
   */
  public record Size(int columns, int rows) {

    /** The size of a terminal that does not report it. */
    public static final Size DEFAULT = new Size(80, 24);

    /** More than any output needs. */
    public static final Size UNLIMITED = new Size(Integer.MAX_VALUE, Integer.MAX_VALUE);

    /** Rejects a size of zero. */
    public Size {
      if (columns < 1 || rows < 1) {
        throw new IllegalArgumentException(
            "a terminal of " + columns + " columns and " + rows + " rows shows nothing");
      }
    }

    /** The output of {@code stty size}, rows first; empty if it does not know the size either. */
    public static Optional<Size> read(String answer) {
      Matcher numbers = STTY.matcher(answer);
      if (!numbers.matches()) {
        return Optional.empty();
      }
      int rows = Integer.parseInt(numbers.group(1));
      int columns = Integer.parseInt(numbers.group(2));
      return rows > 0 && columns > 0 ? Optional.of(new Size(columns, rows)) : Optional.empty();
    }
  }

  private final LongSupplier nanos;
  private final Supplier<String> stty;
  private Optional<Size> last = Optional.empty();
  private long asked;

  /** The terminal in which this process was started. */
  public Terminal() {
    this(System::nanoTime, Terminal::stty);
  }

  /**
   * @param nanos a monotonic clock with any origin, in nanoseconds
   * @param stty output of {@code stty size}
   */
  Terminal(LongSupplier nanos, Supplier<String> stty) {
    this.nanos = nanos;
    this.stty = stty;
  }

  /**
   * Whether printed lines can be redrawn: not in a file or a pipe, and not if {@code NO_COLOR} is
   * set or the terminal is {@code dumb}.
   */
  public static boolean canRedraw() {
    return StatusHighlighter.isEnabled();
  }

  /**
   * Maximum width of a table: the value of {@code COLUMNS}, or the terminal's; {@link Size#DEFAULT}
   * in a file or a pipe.
   */
  public static int columns() {
    return columns(
        System.getenv("COLUMNS"), isTerminal() ? () -> new Terminal().get() : () -> Size.DEFAULT);
  }

  /**
   * Maximum width of a sentence: the terminal's width; unlimited in a file or a pipe, where other
   * programs search for it.
   */
  public static int textColumns() {
    return isTerminal() ? columns() : Size.UNLIMITED.columns();
  }

  /** Whether this process writes to a terminal, whatever its capabilities. */
  public static boolean isTerminal() {
    return Ansi.AUTO.enabled() || (System.getenv("NO_COLOR") != null && System.console() != null);
  }

  static int columns(@Nullable String variable, Supplier<Size> size) {
    return variable != null && variable.matches("[1-9]\\d{1,3}")
        ? Integer.parseInt(variable)
        : size.get().columns();
  }

  @Override
  public Size get() {
    long now = nanos.getAsLong();
    if (last.isEmpty() || now - asked > TimeUnit.MILLISECONDS.toNanos(MILLIS)) {
      asked = now;
      last = Optional.of(Size.read(stty.get()).or(() -> last).orElse(Size.DEFAULT));
    }
    return last.orElseThrow();
  }

  /** Empty if there is no such program, no terminal, or no answer in time. */
  private static String stty() {
    try {
      Process process =
          new ProcessBuilder("stty", "size")
              .redirectInput(new File("/dev/tty"))
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      if (!process.waitFor(STTY_TIMEOUT_MILLIS, TimeUnit.MILLISECONDS)) {
        process.destroyForcibly();
        return "";
      }
      return new String(process.getInputStream().readAllBytes(), StandardCharsets.US_ASCII);
    } catch (IOException e) {
      return ""; // the default size applies
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return "";
    }
  }
}
