package org.dfra.core.effector;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.time.temporal.ChronoUnit;
import java.util.Optional;
import org.dfra.core.state.StateStore;
import org.dfra.core.time.BootId;
import org.dfra.core.time.MonotonicTimestamp;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * Whether an effector is stopped for an emergency, through all its lives.
 *
 * <pre>
 *   free --engage--&gt; latched --release--&gt; free
 * </pre>
 *
 * <p>It counts in memory at once, and from {@link #persist} on in every later life. What cannot be
 * read counts as latched: an effector that stands without need does less harm than one that moves.
 */
public final class EmergencyStopLatch {

  private static final String NAME = "stop";
  private static final MonotonicTimestamp UNKNOWN = new MonotonicTimestamp("", 0);

  private final String module;
  private final StateStore state;
  private final InstantSource clock;
  private final Scheduler time;
  private final BootId boot;
  private final Logger log;

  /** Taken before this; held while writing, so that nothing older is written over a newer one. */
  private final Object file = new Object();

  private volatile Latched now; // written under this
  private volatile @Nullable String persistFault; // written under file; why it cannot be kept

  /**
   * How it is.
   *
   * @param stop of unknown age
   * @param nanos when that was, or a moment after it, by this process's monotonic time; nothing
   *     where {@code since} is null
   */
  private record Latched(EmergencyStopState stop, long nanos) {}

  /**
   * As the last life has left it.
   *
   * @param module the effector's path, {@code robot/name}
   * @param state where it is kept
   * @param clock says since when it is latched, for people
   * @param time tells how long ago that was
   * @param boot that this time belongs to
   */
  EmergencyStopLatch(
      String module,
      StateStore state,
      InstantSource clock,
      Scheduler time,
      BootId boot,
      Logger log) {
    this.module = module;
    this.state = state;
    this.clock = clock;
    this.time = time;
    this.boot = boot;
    this.log = log;
    EmergencyStopCodec.StoredStop kept = read(state);
    MonotonicTimestamp begin = MonotonicTimestamp.now(boot, time);
    EmergencyStopState stop = kept.stop();
    this.now = new Latched(stop, begin.nanos() - kept.moment().minAge(begin).toNanos());
    if (stop.latched()) {
      log.warn("{}{}", refusalMessage(), stop.fault() == null ? "" : " (" + stop.fault() + ")");
    }
  }

  /** What is kept of an effector's stop, whether the effector lives or not; of unknown age. */
  public static EmergencyStopState loadState(StateStore state) {
    return read(state).stop();
  }

  private static EmergencyStopCodec.StoredStop read(StateStore state) {
    try {
      Optional<byte[]> content = state.read(NAME);
      if (content.isEmpty()) {
        return new EmergencyStopCodec.StoredStop(EmergencyStopState.NEVER, UNKNOWN);
      }
      EmergencyStopCodec.@Nullable StoredStop read = EmergencyStopCodec.decode(content.get());
      return read != null ? read : taken(state, "is damaged");
    } catch (IOException e) {
      return taken(state, "cannot be read (" + e + ")");
    }
  }

  private static EmergencyStopCodec.StoredStop taken(StateStore state, String why) {
    EmergencyStopState stop =
        new EmergencyStopState(
            true,
            null,
            null,
            true,
            "what is kept of its emergency stop in "
                + state
                + " "
                + why
                + ", so it is taken to be stopped");
    return new EmergencyStopCodec.StoredStop(stop, UNKNOWN);
  }

  /** How it is, as far as this latch knows. */
  EmergencyStopState state() {
    Latched latched = now;
    EmergencyStopState stop = latched.stop();
    @Nullable Duration age =
        stop.since() == null ? null : Duration.ofNanos(Math.max(0, time.nanos() - latched.nanos()));
    @Nullable String why = persistFault;
    @Nullable String fault = why == null ? stop.fault() : join(stop.fault(), why);
    return new EmergencyStopState(
        stop.latched(), stop.requester(), stop.since(), stop.haltCommanded(), fault, age);
  }

  boolean isLatched() {
    return now.stop().latched();
  }

  /**
   * Latches it, from now on.
   *
   * @param by who asks, for people; any text, also none, see {@link
   *     EmergencyStopState#requesterName}
   * @return false if it was latched already, by somebody who is known; then it stays as it is
   */
  synchronized boolean engage(@Nullable String by) {
    EmergencyStopState stop = now.stop();
    return !(stop.latched() && stop.requester() != null) && set(true, by);
  }

  /**
   * Releases it.
   *
   * @param by as for {@link #engage}
   * @return false if it was not latched
   */
  synchronized boolean release(@Nullable String by) {
    return isLatched() && set(false, by);
  }

  private boolean set(boolean latched, @Nullable String by) {
    Instant since = clock.instant().truncatedTo(ChronoUnit.MILLIS);
    EmergencyStopState stop =
        new EmergencyStopState(latched, EmergencyStopState.requesterName(by), since, true, null);
    now = new Latched(stop, time.nanos());
    return true;
  }

  /**
   * Writes it down for the lives to come, before it returns.
   *
   * @return whether it could be written; where not, {@link #state} says why
   */
  boolean persist() {
    synchronized (file) {
      Latched latched = now;
      EmergencyStopState stop = latched.stop();
      @Nullable Instant since = stop.since();
      @Nullable String by = stop.requester();
      if (since == null || by == null) {
        return true; // what was read and never changed
      }
      try {
        MonotonicTimestamp moment =
            new MonotonicTimestamp(MonotonicTimestamp.now(boot, time).bootId(), latched.nanos());
        state.write(NAME, EmergencyStopCodec.encode(stop.latched(), since, by, moment));
        persistFault = null;
        return true;
      } catch (IOException e) {
        persistFault =
            "it cannot be written to "
                + state
                + " ("
                + e
                + "), so the next life of this module would not know of it";
        log.error("{}: of its emergency stop: {}", module, persistFault);
        return false;
      }
    }
  }

  /** Why it obeys nobody, one sentence with the remedy. */
  String refusalMessage() {
    int slash = module.indexOf('/');
    return module
        + " is stopped for an emergency "
        + now.stop().inWords()
        + ", and obeys nobody; when it is safe, release it: ./dfra stop --release "
        + (slash < 0 ? module : module.substring(0, slash));
  }

  static @Nullable String join(@Nullable String one, @Nullable String other) {
    return one == null ? other : other == null ? one : one + "; " + other;
  }
}
