package org.dfra.core.module;

import java.time.Duration;
import java.util.function.BiConsumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.dfra.module.NotReadyException;
import org.dfra.module.Readiness;
import org.jspecify.annotations.Nullable;

/**
 * What a module last told or perceived, for as long as it counts, and the readiness that follows
 * from it.
 *
 * <pre>
 *                   .------ set ------&gt; READY or ACTIVE: get() answers, while it is young enough
 *   INITIALIZING --'                          |
 *    get() is refused with what it awaits     |
 *         ^--------------- lose --------------'
 * </pre>
 *
 * <p>One thread at a time sets, amends, loses and forgets: the reader of the device's link, and
 * before and after its life the module's owner. Any thread may ask.
 *
 * @param <T> what is told; immutable
 */
public final class LatestReading<T> {

  /**
   * A reading.
   *
   * @param value what was told
   * @param nanos when it came, by the module's time
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
   * @param what it is, for people: {@code scan}, {@code position}
   * @param module whose reading it is
   * @param transition moves the module along an arrow of {@link Readiness}, with the reason as a
   *     clause
   * @param nanos the time by which it ages, nanoseconds
   * @param maxAge how old a reading may be when it is served; as things are now
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

  /** A new one has come; a module that is INITIALIZING becomes READY by it. */
  public void set(T value) {
    set(value, Duration.ZERO);
  }

  /**
   * The same, of one that was some time on its way; one that is too old to count is left out.
   *
   * @param age of it now, not negative
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

  /** Something is to be added to the last one, which is no younger for it; nothing without one. */
  public void amend(T value) {
    @Nullable Taken<T> now = last;
    if (now != null) {
      last = new Taken<>(value, now.nanos());
    }
  }

  /** There is none any more, since none comes; a module that serves ceases to. */
  public void markLost(String reason) {
    clear(reason);
    if (module.readiness().serves()) {
      become.accept(Readiness.INITIALIZING, reason);
    }
  }

  /**
   * There is none any more; the module's readiness is the caller's.
   *
   * @param reason why, as a clause
   */
  public void clear(String reason) {
    awaits = reason;
    last = null;
  }

  /**
   * Says what is missing as long as there is none.
   *
   * @param clause as in {@code its link is being opened}
   */
  public void setMissing(String clause) {
    awaits = clause;
  }

  /** What is missing, or was before the last one came, as a clause. */
  public String missing() {
    return awaits;
  }

  /**
   * The last one, where it may be served.
   *
   * @throws NotReadyException if there is none, the module does not serve, or the last one is too
   *     old to count
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

  /** The last one, however old and whether it may be served or not; null if there is none. */
  public @Nullable T peek() {
    @Nullable Taken<T> now = last;
    return now == null ? null : now.value();
  }

  /** Whether there is one, but too old to be served. */
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
