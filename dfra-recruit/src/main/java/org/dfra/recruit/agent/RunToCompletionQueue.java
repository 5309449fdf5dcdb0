package org.dfra.recruit.agent;

import java.util.ArrayDeque;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * One thing happens after the other. What is asked for by the thing that happens now, such as by a
 * lease that ends since it is cancelled, happens next.
 */
final class RunToCompletionQueue {

  private final ArrayDeque<Runnable> waiting = new ArrayDeque<>(); // guarded by this
  private boolean isTaken; // guarded by this

  /** Has it happen before this returns, unless called by what happens now. */
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
        } catch (RuntimeException e) { // what was asked for meanwhile must happen nevertheless
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

  /** Looks at something between two turns. */
  synchronized <T> T query(Supplier<T> look) {
    return look.get();
  }
}
