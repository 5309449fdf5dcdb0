package org.dfra.core.effector;

import java.io.IOException;
import java.time.Instant;
import java.time.InstantSource;
import java.time.temporal.ChronoUnit;
import java.util.Optional;
import org.dfra.core.state.StateStore;
import org.dfra.flow.effector.StopState;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * Whether an effector is stopped for an emergency, through all its lives.
 *
 * <pre>
 *   free --engage--&gt; latched --release--&gt; free
 * </pre>
 *
 * <p>It counts in memory at once, and from {@link #keep} on in every later life. What cannot be
 * read counts as latched: an effector that stands without need does less harm than one that moves.
 */
public final class StopLatch {

  private static final String NAME = "stop";

  private final String module;
  private final StateStore state;
  private final InstantSource clock;
  private final Logger log;

  /** Taken before this; held while writing, so that nothing older is written over a newer one. */
  private final Object file = new Object();

  private volatile StopState now; // written under this
  private volatile @Nullable String unkept; // written under file; why it cannot be kept

  /**
   * As the last life has left it.
   *
   * @param module the effector's path, {@code robot/name}
   * @param state where it is kept
   * @param clock says since when it is latched
   */
  StopLatch(String module, StateStore state, InstantSource clock, Logger log) {
    this.module = module;
    this.state = state;
    this.clock = clock;
    this.log = log;
    this.now = kept(state);
    if (now.latched()) {
      log.warn("{}{}", refusal(), now.fault() == null ? "" : " (" + now.fault() + ")");
    }
  }

  /** What is kept of an effector's stop, whether the effector lives or not. */
  public static StopState kept(StateStore state) {
    try {
      Optional<byte[]> content = state.read(NAME);
      if (content.isEmpty()) {
        return StopState.NEVER;
      }
      @Nullable StopState read = StopForm.read(content.get());
      return read != null ? read : taken(state, "is damaged");
    } catch (IOException e) {
      return taken(state, "cannot be read (" + e + ")");
    }
  }

  private static StopState taken(StateStore state, String why) {
    return new StopState(
        true,
        null,
        null,
        true,
        "what is kept of its emergency stop in "
            + state
            + " "
            + why
            + ", so it is taken to be stopped");
  }

  /** How it is, as far as this latch knows. */
  StopState state() {
    StopState stop = now;
    @Nullable String why = unkept;
    return why == null
        ? stop
        : new StopState(
            stop.latched(), stop.by(), stop.since(), stop.resting(), join(stop.fault(), why));
  }

  boolean isLatched() {
    return now.latched();
  }

  /**
   * Latches it, from now on.
   *
   * @param by who asks, for people; any text, also none, see {@link StopState#requesterName}
   * @return false if it was latched already, by somebody who is known; then it stays as it is
   */
  synchronized boolean engage(@Nullable String by) {
    return !(now.latched() && now.by() != null) && set(true, by);
  }

  /**
   * Releases it.
   *
   * @param by as for {@link #engage}
   * @return false if it was not latched
   */
  synchronized boolean release(@Nullable String by) {
    return now.latched() && set(false, by);
  }

  private boolean set(boolean latched, @Nullable String by) {
    Instant since = clock.instant().truncatedTo(ChronoUnit.MILLIS);
    now = new StopState(latched, StopState.requesterName(by), since, true, null);
    return true;
  }

  /**
   * Writes it down for the lives to come, before it returns.
   *
   * @return whether it could be written; where not, {@link #state} says why
   */
  boolean keep() {
    synchronized (file) {
      StopState stop = now;
      @Nullable Instant since = stop.since();
      @Nullable String by = stop.by();
      if (since == null || by == null) {
        return true; // what was read and never changed
      }
      try {
        state.write(NAME, StopForm.write(stop.latched(), since, by));
        unkept = null;
        return true;
      } catch (IOException e) {
        unkept =
            "it cannot be written to "
                + state
                + " ("
                + e
                + "), so the next life of this module would not know of it";
        log.error("{}: of its emergency stop: {}", module, unkept);
        return false;
      }
    }
  }

  /** Why it obeys nobody, one sentence with the remedy. */
  String refusal() {
    int slash = module.indexOf('/');
    return module
        + " is stopped for an emergency "
        + now.inWords()
        + ", and obeys nobody; when it is safe, release it: ./dfra stop --release "
        + (slash < 0 ? module : module.substring(0, slash));
  }

  static @Nullable String join(@Nullable String one, @Nullable String other) {
    return one == null ? other : other == null ? one : one + "; " + other;
  }
}
