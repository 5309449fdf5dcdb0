package org.dfra.core.time;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.time.DateTimeException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.time.Scheduler;

/**
 * Scaled time: it equals real time until an instant and runs at another speed since. It is the same
 * in every virtual machine of a computer that is configured with it, so that devices, drivers and
 * behaviours of a simulated robot agree. Clock and scheduler in one. Its text is {@code 4x since
 * 2026-11-21T16:00:00Z}, and {@link #toHostText} as {@code 4x since 2026-11-21T16:00:00Z (boot
 * 1b9d6bcd-bbfd-4b2d-9b5d-ab8dfbbd4bed, 86400.123456789 s)}: the uptime of the computer at that
 * instant.
 *
 * <p>It runs evenly even if the computer's clock is set meanwhile, and virtual machines that are
 * started before and after that agree. If the text has no boot, or that of another computer or of
 * an earlier boot, the computer's clock is read once, at construction.
 */
public final class ScaledTime implements InstantSource, Scheduler {

  /** The minimum and the maximum speed. */
  public static final double MIN_SPEED = 0.01;

  /** See {@link #MIN_SPEED}. */
  public static final double MAX_SPEED = 1000;

  private static final Pattern TEXT =
      Pattern.compile(
          "([0-9.]{1,20})x since (\\S+)(?: \\(boot (\\S+), (-?\\d{1,9}\\.\\d{9}) s\\))?");

  private final double speed;
  private final Instant since;
  private final Scheduler real;
  private final long beginNanos; // of the real monotonic clock, at the instant {@code since}

  /**
   * @param speed seconds of this time per real second, {@value #MIN_SPEED} to {@value #MAX_SPEED}
   * @param since the instant until which it equals real time
   */
  public ScaledTime(double speed, Instant since) {
    this(speed, since, InstantSource.system(), Scheduler.system());
  }

  /** For tests: with another real-time clock. */
  ScaledTime(double speed, Instant since, InstantSource clock, Scheduler real) {
    this(speed, since, real, real.nanos() - Duration.between(since, clock.instant()).toNanos());
  }

  private ScaledTime(double speed, Instant since, Scheduler real, long beginNanos) {
    if (!(speed >= MIN_SPEED && speed <= MAX_SPEED)) {
      throw new IllegalArgumentException(
          "speed " + speed + " is outside " + MIN_SPEED + " to " + MAX_SPEED);
    }
    this.speed = speed;
    this.since = since;
    this.real = real;
    this.beginNanos = beginNanos;
  }

  /**
   * Parses the format of {@link #toString}.
   *
   * @throws IllegalArgumentException if it is not one; the message describes the format
   * @throws UncheckedIOException if it names a boot, and the ID of the current boot cannot be read
   *     now
   */
  public static ScaledTime parse(String text) {
    return parse(text, BootId.system(), InstantSource.system(), Scheduler.system());
  }

  /** For tests: with another real-time clock. */
  static ScaledTime parse(String text, BootId boot, InstantSource clock, Scheduler real) {
    Matcher parts = TEXT.matcher(text.strip());
    if (parts.matches()) {
      try {
        double speed = Double.parseDouble(parts.group(1));
        Instant since = Instant.parse(parts.group(2));
        return parts.group(3) != null && id(boot).equals(Optional.of(parts.group(3)))
            ? new ScaledTime(
                speed, since, real, new BigDecimal(parts.group(4)).movePointRight(9).longValue())
            : new ScaledTime(speed, since, clock, real);
      } catch (NumberFormatException | DateTimeException e) {
        // reported below
      }
    }
    throw new IllegalArgumentException(
        "\"" + text + "\" is not a time; write it like 4x since 2026-11-21T16:00:00Z");
  }

  /** Seconds of this time per real second. */
  public double speed() {
    return speed;
  }

  @Override
  public Instant instant() {
    return since.plusNanos(nanos());
  }

  /** Nanoseconds of this time since the instant until which it equals real time. */
  @Override
  public long nanos() {
    return (long) ((real.nanos() - beginNanos) * speed);
  }

  @Override
  public ScheduledTask after(long nanos, Runnable task) {
    return real.after(realNanos(nanos), task);
  }

  private long realNanos(long nanos) {
    return (long) Math.ceil(nanos / speed);
  }

  @Override
  public Scheduler commandTimer() {
    Scheduler timer = real.commandTimer();
    return new Scheduler() {
      @Override
      public long nanos() {
        return ScaledTime.this.nanos();
      }

      @Override
      public ScheduledTask after(long nanos, Runnable task) {
        return timer.after(realNanos(nanos), task);
      }
    };
  }

  /**
   * The text for other virtual machines of this computer, so that they agree with this one even if
   * the computer's clock is set before they are started. Other computers accept it too, and use
   * their own clocks.
   *
   * @throws UncheckedIOException if the boot cannot be read now
   */
  public String toHostText() {
    return toHostText(BootId.system());
  }

  /** For tests: on another computer. */
  String toHostText(BootId boot) {
    return id(boot)
        .map(id -> this + " (boot " + id + ", " + seconds(beginNanos) + " s)")
        .orElseGet(this::toString);
  }

  private static String seconds(long nanos) {
    return BigDecimal.valueOf(nanos, 9).toPlainString();
  }

  private static Optional<String> id(BootId boot) {
    try {
      return boot.read();
    } catch (IOException e) {
      throw new UncheckedIOException(
          "which boot of this computer it is cannot be read ("
              + e.getMessage()
              + "); where too many files are open, close some or raise the limit (ulimit -n)",
          e);
    }
  }

  @Override
  public String toString() {
    String number =
        speed == Math.rint(speed) ? Long.toString((long) speed) : Double.toString(speed);
    return String.format(Locale.ROOT, "%sx since %s", number, since);
  }
}
