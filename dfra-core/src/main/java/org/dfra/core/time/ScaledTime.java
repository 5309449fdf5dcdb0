package org.dfra.core.time;

import java.time.DateTimeException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.time.Scheduler;

/**
 * Time that was real until an instant and runs at another speed since: the same in every virtual
 * machine of a computer that was told of it, so that devices, drivers and behaviours of a simulated
 * robot agree. Clock and scheduler in one. It writes itself as {@code 4x since
 * 2026-11-21T16:00:00Z}.
 *
 * <p>It goes on evenly even where the computer's clock is set meanwhile; a virtual machine takes
 * that clock into account once, when this is made.
 */
public final class ScaledTime implements InstantSource, Scheduler {

  /** The slowest and the fastest there is. */
  public static final double SLOWEST = 0.01;

  /** See {@link #SLOWEST}. */
  public static final double FASTEST = 1000;

  private static final Pattern TEXT = Pattern.compile("([0-9.]+)x since (\\S+)");

  private final double speed;
  private final Instant since;
  private final Scheduler real;
  private final long beginNanos; // of real, at the instant since

  /**
   * @param speed seconds of this time in a real second, {@value #SLOWEST} to {@value #FASTEST}
   * @param since when it was real
   */
  public ScaledTime(double speed, Instant since) {
    this(speed, since, InstantSource.system(), Scheduler.system());
  }

  /** For tests: by another real time. */
  ScaledTime(double speed, Instant since, InstantSource clock, Scheduler real) {
    if (!(speed >= SLOWEST && speed <= FASTEST)) {
      throw new IllegalArgumentException(
          "speed " + speed + " is outside " + SLOWEST + " to " + FASTEST);
    }
    this.speed = speed;
    this.since = since;
    this.real = real;
    this.beginNanos = real.nanos() - Duration.between(since, clock.instant()).toNanos();
  }

  /**
   * Reads what {@link #toString} wrote.
   *
   * @throws IllegalArgumentException if it is none; the message says what one looks like
   */
  public static ScaledTime parse(String text) {
    Matcher parts = TEXT.matcher(text.strip());
    if (parts.matches()) {
      try {
        return new ScaledTime(Double.parseDouble(parts.group(1)), Instant.parse(parts.group(2)));
      } catch (NumberFormatException | DateTimeException e) {
        // told below
      }
    }
    throw new IllegalArgumentException(
        "\"" + text + "\" is no time; write it like 4x since 2026-11-21T16:00:00Z");
  }

  /** Seconds of this time in a real second. */
  public double speed() {
    return speed;
  }

  @Override
  public Instant instant() {
    return since.plusNanos(nanos());
  }

  /** Nanoseconds of this time since it was real. */
  @Override
  public long nanos() {
    return (long) ((real.nanos() - beginNanos) * speed);
  }

  @Override
  public Task after(long nanos, Runnable task) {
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
      public Task after(long nanos, Runnable task) {
        return timer.after(realNanos(nanos), task);
      }
    };
  }

  @Override
  public String toString() {
    String number =
        speed == Math.rint(speed) ? Long.toString((long) speed) : Double.toString(speed);
    return String.format(Locale.ROOT, "%sx since %s", number, since);
  }
}
