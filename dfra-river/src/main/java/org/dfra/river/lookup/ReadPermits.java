package org.dfra.river.lookup;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Limits how many lookup services this virtual machine reads completely at the same time. A program
 * that starts in a large team finds all of them at once: without the limit it would have a thread
 * for each, and the team's programs together more calls in progress than their deadlines allow.
 *
 * <p>Those that must wait get their permits in order, and have no thread meanwhile. Thread-safe.
 */
final class ReadPermits {

  /** Those of this virtual machine. */
  static final ReadPermits SHARED = new ReadPermits(8);

  private final int most;

  @GuardedBy("this")
  private final Set<Object> holders = new LinkedHashSet<>();

  /** What to run when a reader gets its permit, in order of arrival. */
  @GuardedBy("this")
  private final Map<Object, Runnable> waiting = new LinkedHashMap<>();

  /**
   * @param most number of permits
   */
  ReadPermits(int most) {
    this.most = most;
  }

  /**
   * Whether a reader has a permit, now or still. Otherwise it waits for one.
   *
   * @param onPermit runs when it gets one later, on another reader's thread; must not block
   */
  synchronized boolean acquire(Object reader, Runnable onPermit) {
    if (holders.contains(reader)) {
      return true;
    }
    if (holders.size() < most) {
      return holders.add(reader);
    }
    waiting.putIfAbsent(reader, onPermit);
    return false;
  }

  /** Gives back a reader's permit, or ends its wait. Does nothing if it has no part in this. */
  void release(Object reader) {
    @Nullable Runnable onPermit = null;
    synchronized (this) {
      waiting.remove(reader);
      if (holders.remove(reader) && !waiting.isEmpty()) {
        Iterator<Map.Entry<Object, Runnable>> first = waiting.entrySet().iterator();
        Map.Entry<Object, Runnable> next = first.next();
        first.remove();
        holders.add(next.getKey());
        onPermit = next.getValue();
      }
    }
    if (onPermit != null) {
      onPermit.run();
    }
  }
}
