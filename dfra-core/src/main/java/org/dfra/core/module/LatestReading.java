package org.dfra.core.module;

import java.time.Duration;
import java.util.function.BiConsumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.jspecify.annotations.Nullable;

/**
 * The latest reading of a module, while it is valid, and the readiness that follows from it.
 *
 * <pre>
 *                   .------ set ------&gt; READY or ACTIVE: get() answers until it is too old
 *   INITIALIZING --'                          |
 *    get() throws and names what it awaits    |
 *         ^------------- markLost ------------'
 * </pre>
 *
 * <p>One thread at a time modifies it: the reader of the device's link, or, before start and after
 * close, the module's owner. Any thread may read it.
 *
 * @param <T> the type of reading; immutable
 */
public final class LatestReading<T> {

  /**
   * A reading.
   *
   * @param value the value
   * @param nanos when it arrived, by the module's clock
   */
  private record Taken<T>(T value, long nanos) {}

  private final String what;
  private final ModuleImpl module;
  private final BiConsumer<Readiness, String> become;
  private final LongSupplier nanos;
  private final Supplier<Duration> longestAge;

  private volatile @Nullable Taken<T> last; // null: none to be served
  private volatile String awaits = "it has not been started";

  /**
   * @param what its name in messages: {@code scan}, {@code position}
   * @param module the module of the reading
   * @param transition makes a transition of {@link Readiness}, with the reason as a clause
   * @param nanos the clock of its age, nanoseconds
   * @param maxAge returns the current maximum age of a served reading
   */
  public LatestReading(
      String what,
      ModuleImpl module,
      BiConsumer<Readiness, String> transition,
      LongSupplier nanos,
      Supplier<Duration> maxAge) {
    this.what = what;
    this.module = module;
    this.become = transition;
    this.nanos = nanos;
    this.longestAge = maxAge;
    module.addRequiredReading(this);
  }

  /** Sets a new reading; a module that is INITIALIZING becomes READY. */
  public void set(T value) {
    set(value, Duration.ZERO);
  }

  /**
   * The same, for a delayed reading; one that is too old is ignored.
   *
   * @param age its current age, not negative
   */
  public void set(T value, Duration age) {
    if (age.compareTo(longestAge.get()) > 0) {
      return;
    }
    last = new Taken<>(value, nanos.getAsLong() - age.toNanos());
    if (module.readiness() == Readiness.INITIALIZING) {
      become.accept(Readiness.READY, "its first " + what + " has come");
    }
  }

  /** Replaces the last value without changing its age; does nothing if there is none. */
  public void replaceValue(T value) {
    @Nullable Taken<T> now = last;
    if (now != null) {
      last = new Taken<>(value, now.nanos());
    }
  }

  /** Clears the reading, since no new ones arrive; a module that serves becomes INITIALIZING. */
  public void markLost(String reason) {
    clear(reason);
    if (module.readiness().serves()) {
      become.accept(Readiness.INITIALIZING, reason);
    }
  }

  /**
   * Clears the reading; the caller sets the module's readiness.
   *
   * @param reason the reason, as a clause
   */
  public void clear(String reason) {
    awaits = reason;
    last = null;
  }

  /**
   * Sets what is missing as long as there is no reading.
   *
   * @param clause as in {@code its link is being opened}
   */
  public void setMissing(String clause) {
    awaits = clause;
  }

  /** What is missing, or was before the last reading arrived, as a clause. */
  public String missing() {
    return awaits;
  }

  /**
   * The last reading, if it may be served.
   *
   * @throws NotReadyException if there is none, the module does not serve, or the last one is too
   *     old
   */
  public T get() {
    @Nullable Taken<T> now = last;
    Readiness readiness = module.readiness();
    if (now == null || !readiness.serves()) {
      throw new NotReadyException(path(), readiness, awaits);
    }
    Duration age = age(now);
    Duration longest = longestAge.get();
    if (age.compareTo(longest) > 0) {
      throw new NotReadyException(
          path(),
          readiness,
          "its last "
              + what
              + " is "
              + seconds(age)
              + " old, and none older than "
              + seconds(longest)
              + " is served");
    }
    return now.value();
  }

  /** The last reading, even if it is too old or may not be served; null if there is none. */
  public @Nullable T peek() {
    @Nullable Taken<T> now = last;
    return now == null ? null : now.value();
  }

  /** Whether there is a reading, but too old to be served. */
  public boolean isTooOld() {
    @Nullable Taken<T> now = last;
    return now != null && age(now).compareTo(longestAge.get()) > 0;
  }

  private Duration age(Taken<T> taken) {
    return Duration.ofNanos(nanos.getAsLong() - taken.nanos());
  }

  /** {@code 5 s} or {@code 2.3 s}. */
  public static String seconds(Duration duration) {
    double seconds = duration.toMillis() / 1e3;
    return (seconds == Math.rint(seconds) ? Long.toString((long) seconds) : seconds + "") + " s";
  }

  private String path() {
    return module.identification().path();
  }
}
