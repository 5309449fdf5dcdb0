package org.dfra.app.terminal;

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
 * The terminal that this process writes to. Its size is asked for again every {@value #MILLIS} ms,
 * since people drag windows. Not safe for use by several threads.
 */
public final class Terminal implements Supplier<Terminal.Size> {

  private static final int MILLIS = 150; // what is drawn anew by a wrong size leaves ghosts
  private static final long STTY_TIMEOUT_MILLIS = 500;
  private static final Pattern STTY = Pattern.compile("\\s*(\\d{1,5})\\s+(\\d{1,5})\\s*");

  /**
   * How much it shows.
   *
   * @param columns characters in a line
   * @param rows lines
   */
  public record Size(int columns, int rows) {

    /** What a terminal has that does not say. */
    public static final Size DEFAULT = new Size(80, 24);

    /** More than anything that is shown. */
    public static final Size UNLIMITED = new Size(Integer.MAX_VALUE, Integer.MAX_VALUE);

    /** Refuses a terminal that shows nothing. */
    public Size {
      if (columns < 1 || rows < 1) {
        throw new IllegalArgumentException(
            "a terminal of " + columns + " columns and " + rows + " rows shows nothing");
      }
    }

    /** What {@code stty size} answered, rows first; nothing where it does not know either. */
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

  /** The one that this process was started in. */
  public Terminal() {
    this(System::nanoTime, Terminal::stty);
  }

  /**
   * @param nanos a clock that only differences are taken of, in nanoseconds
   * @param stty answers as {@code stty size} does
   */
  Terminal(LongSupplier nanos, Supplier<String> stty) {
    this.nanos = nanos;
    this.stty = stty;
  }

  /**
   * Whether lines that were written can be written anew: not into a file or a pipe, and not where
   * {@code NO_COLOR} is set or the terminal is {@code dumb}.
   */
  public static boolean canRedraw() {
    return StatusHighlighter.isEnabled();
  }

  /**
   * How wide a table may be: what {@code COLUMNS} says, or the terminal; {@link Size#DEFAULT} in a
   * file or a pipe.
   */
  public static int columns() {
    return columns(
        System.getenv("COLUMNS"), isTerminal() ? () -> new Terminal().get() : () -> Size.DEFAULT);
  }

  /**
   * How wide a sentence may be: as wide as the terminal, and however wide in a file or a pipe,
   * where other programs look for it.
   */
  public static int textColumns() {
    return isTerminal() ? columns() : Size.UNLIMITED.columns();
  }

  /** Whether this process writes to a terminal, whatever that can show. */
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

  /** Nothing where there is no such program, no terminal, or no answer in time. */
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
      return ""; // the usual size does
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return "";
    }
  }
}
