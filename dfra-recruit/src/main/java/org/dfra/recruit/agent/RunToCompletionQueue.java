package org.dfra.recruit.agent;

import java.util.ArrayDeque;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * Runs one event after the other. An event submitted by the running event, such as the end of a
 * lease that it cancels, runs next.
 */
final class RunToCompletionQueue {

  private final ArrayDeque<Runnable> waiting = new ArrayDeque<>(); // guarded by this
  private boolean isTaken; // guarded by this

  /** Runs an event before this returns, unless the running event calls it. */
  synchronized void run(Runnable turn) {
    waiting.add(turn);
    if (isTaken) {
      return;
    }
    isTaken = true;
    @Nullable RuntimeException failure = null;
    try {
      for (Runnable next = waiting.poll(); next != null; next = waiting.poll()) {
        try {
          next.run();
        } catch (RuntimeException e) { // events submitted meanwhile must run nevertheless
          failure = failure == null ? e : failure;
        }
      }
    } finally {
      isTaken = false;
    }
    if (failure != null) {
      throw failure;
    }
  }

  /** Reads state between two events. */
  synchronized <T> T query(Supplier<T> look) {
    return look.get();
  }
}
