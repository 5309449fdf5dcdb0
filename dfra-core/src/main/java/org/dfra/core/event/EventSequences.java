package org.dfra.core.event;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.InstantSource;
import org.dfra.core.state.StateStore;
import org.dfra.core.state.StateStore.Counters;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The sequence numbers of a module's events across restarts: its epoch, and one sequence for each
 * kind of event.
 *
 * <p>They survive the death of the process at any moment. After a power loss the sequences may fall
 * back to their values at the last activation; the epoch does not, since each activation syncs it
 * to disk before its first event. So a listener can recognize a sequence that falls back by its new
 * epoch. If they cannot be stored at all, the robot continues: the epoch is then the time.
 *
 * <p>Read on first use, not when constructed. Confined to its {@link EventHub}'s lock.
 */
final class EventSequences {

  private static final Logger LOG = LoggerFactory.getLogger(EventSequences.class);
  private static final String NAME = "events";
  private static final int EPOCH = 0;
  private static final int FIRST_KIND = 1;

  private final StateStore state;
  private final InstantSource clock;
  private @Nullable Counters counters;

  EventSequences(StateStore state, InstantSource clock) {
    this.state = state;
    this.clock = clock;
  }

  long epoch() {
    return counters().get(EPOCH);
  }

  /** Allocates the sequence number of the next event of a kind. */
  long next(EventKind kind) {
    int index = FIRST_KIND + kind.ordinal();
    long number = counters().get(index) + 1;
    counters().set(index, number);
    return number;
  }

  /** The last allocated number of each kind, by ordinal. */
  long[] last() {
    long[] last = new long[EventKind.values().length];
    for (int i = 0; i < last.length; i++) {
      last[i] = counters().get(FIRST_KIND + i);
    }
    return last;
  }

  private Counters counters() {
    if (counters == null) {
      counters = open();
    }
    return counters;
  }

  private Counters open() {
    int count = FIRST_KIND + EventKind.values().length;
    try {
      Counters kept = state.counters(NAME, count);
      kept.set(EPOCH, kept.get(EPOCH) + 1);
      kept.force();
      return kept;
    } catch (IOException | UncheckedIOException e) {
      LOG.error(
          "the numbers of a module's events cannot be kept in {}, so they begin again with each"
              + " activation: {}",
          state,
          e.toString());
      Counters fresh = Counters.inMemory(count);
      fresh.set(EPOCH, clock.millis());
      return fresh;
    }
  }
}
