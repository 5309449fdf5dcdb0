package org.dfra.core.effector;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.time.temporal.ChronoUnit;
import java.util.Optional;
import org.dfra.core.host.CommandName;
import org.dfra.core.state.StateStore;
import org.dfra.core.time.BootId;
import org.dfra.core.time.MonotonicTimestamp;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * The emergency-stop state of an effector, across restarts.
 *
 * <pre>
 *   free --engage--&gt; latched --release--&gt; free
 * </pre>
 *
 * <p>It is effective in memory at once, and from {@link #persist} on across restarts. An unreadable
 * state counts as latched: an effector that is stopped needlessly does less harm than one that
 * moves.
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

  /** Taken before this; held while writing, so that an older state never overwrites a newer one. */
  private final Object file = new Object();

  private volatile Latched now; // written under this
  private volatile @Nullable String persistFault; // written under file; why it cannot be stored

  /**
   * The current state.
   *
   * @param stop the state, of unknown age
   * @param nanos when that was, or shortly after, by this process's monotonic clock; meaningless if
   *     {@code since} is null
   */
  private record Latched(EmergencyStopState stop, long nanos) {}

  /**
   * Loads the state of the previous run.
   *
   * @param module the effector's path, {@code robot/name}
   * @param state where it is stored
   * @param clock the clock of {@code since}, for display
   * @param time the monotonic clock that measures its age
   * @param boot the boot that this clock belongs to
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

  /** The stored state of an effector, whether it runs or not; of unknown age. */
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

  /** The state, as far as this latch knows it. */
  EmergencyStopState state() {
    Latched latched = now;
    EmergencyStopState stop = latched.stop();
    @Nullable Duration age =
        stop.since() == null ? null : Duration.ofNanos(Math.max(0, time.nanos() - latched.nanos()));
    @Nullable String why = persistFault;
    @Nullable String fault = why == null ? stop.fault() : join(stop.fault(), why);
    return stop.withFault(fault, age);
  }

  boolean isLatched() {
    return now.stop().latched();
  }

  /**
   * Latches it.
   *
   * @param by the requester's name, for display; any text, also null, see {@link
   *     EmergencyStopState#requesterName}
   * @return false if it was latched already by a known requester; then it is unchanged
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
   * Stores it synchronously for later runs.
   *
   * @return whether it could be written; if not, {@link #state} reports the reason
   */
  boolean persist() {
    synchronized (file) {
      Latched latched = now;
      EmergencyStopState stop = latched.stop();
      @Nullable Instant since = stop.since();
      @Nullable String by = stop.requester();
      if (since == null || by == null) {
        return true; // was loaded and never changed
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
                + "), so the module would not know of it after a restart";
        log.error("{}: of its emergency stop: {}", module, persistFault);
        return false;
      }
    }
  }

  /** Why it accepts no commands, one sentence with the remedy. */
  String refusalMessage() {
    int slash = module.indexOf('/');
    return module
        + " is stopped for an emergency "
        + now.stop().inWords()
        + ", and executes no commands; when it is safe, release it: "
        + CommandName.current()
        + " stop --release "
        + (slash < 0 ? module : module.substring(0, slash));
  }

  static @Nullable String join(@Nullable String one, @Nullable String other) {
    return one == null ? other : other == null ? one : one + "; " + other;
  }
}
