package org.dfra.river.lookup;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Limits how many lookup services this virtual machine reads completely at the same time, in all
 * and at one address. A program that starts in a large team finds all of them at once: without the
 * limit it would have a thread for each, and the team's programs together more calls in progress
 * than their deadlines allow.
 *
 * <p>Those that must wait get their permits in order, and have no thread meanwhile. A permit is not
 * held for long, even if a lookup service does not answer: {@link RegistrarMonitor#check} gives it
 * back. Thread-safe.
 */
final class ReadPermits {

  /** Those of this virtual machine. */
  static final ReadPermits SHARED = new ReadPermits(8, 4);

  private record Waiting(Object origin, Runnable onPermit) {}

  private record Held(Object origin, long since) {}

  private final int most;
  private final int mostOfOne;

  /** By reader. */
  @GuardedBy("this")
  private final Map<Object, Held> holders = new HashMap<>();

  /** By reader, in order of arrival. */
  @GuardedBy("this")
  private final Map<Object, Waiting> waiting = new LinkedHashMap<>();

  /**
   * @param most number of permits
   * @param mostOfOne how many of them those at one address may have
   */
  ReadPermits(int most, int mostOfOne) {
    this.most = most;
    this.mostOfOne = mostOfOne;
  }

  /**
   * Whether a reader has a permit, now or still. Otherwise it waits for one.
   *
   * @param origin the address that it reads from
   * @param onPermit runs when it gets one later, on another reader's thread; must not block
   */
  synchronized boolean acquire(Object reader, Object origin, Runnable onPermit) {
    if (holders.containsKey(reader)) {
      return true;
    }
    if (isFree(origin)) {
      waiting.remove(reader);
      hold(reader, origin);
      return true;
    }
    waiting.putIfAbsent(reader, new Waiting(origin, onPermit));
    return false;
  }

  @GuardedBy("this")
  private boolean isFree(Object origin) {
    return holders.size() < most
        && holders.values().stream().filter(each -> each.origin().equals(origin)).count()
            < mostOfOne;
  }

  @GuardedBy("this")
  private void hold(Object reader, Object origin) {
    holders.put(reader, new Held(origin, System.nanoTime()));
  }

  /** Gives back a reader's permit if it was granted more than {@code nanos} ago. */
  void releaseAfter(Object reader, long nanos) {
    synchronized (this) {
      Held held = holders.get(reader);
      if (held == null || System.nanoTime() - held.since() <= nanos) {
        return;
      }
    }
    release(reader);
  }

  /** Gives back a reader's permit, or ends its wait. Does nothing if it has no part in this. */
  void release(Object reader) {
    @Nullable Runnable onPermit = null;
    synchronized (this) {
      waiting.remove(reader);
      if (holders.remove(reader) != null) {
        onPermit = grantNext();
      }
    }
    if (onPermit != null) {
      onPermit.run();
    }
  }

  @GuardedBy("this")
  private @Nullable Runnable grantNext() {
    Iterator<Map.Entry<Object, Waiting>> all = waiting.entrySet().iterator();
    while (all.hasNext()) {
      Map.Entry<Object, Waiting> next = all.next();
      if (isFree(next.getValue().origin())) {
        all.remove();
        hold(next.getKey(), next.getValue().origin());
        return next.getValue().onPermit();
      }
    }
    return null;
  }
}
