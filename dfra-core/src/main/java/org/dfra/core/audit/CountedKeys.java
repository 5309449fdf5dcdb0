package org.dfra.core.audit;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Counts equal things, of a bounded number of different ones. Any thread counts; one thread takes
 * the counts. No count is lost between them.
 */
final class CountedKeys<K> {

  /** Of a count that was removed: counting it has no effect. */
  private static final long RETIRED = Long.MIN_VALUE / 2;

  /** What became of a thing that was added. */
  enum Added {
    /** It is the first of its kind. */
    FIRST,
    /** An equal one was there, and was counted. */
    COUNTED,
    /** There are too many different ones; it was not counted. */
    FULL
  }

  /** How many equal things were counted. */
  record Counted<K>(K key, long count) {}

  private final ConcurrentHashMap<K, AtomicLong> counts = new ConcurrentHashMap<>();
  private final int most;

  CountedKeys(int most) {
    this.most = most;
  }

  /** Counts a thing if an equal one was added before. */
  boolean count(K key) {
    AtomicLong count = counts.get(key);
    return count != null && count.incrementAndGet() > 0;
  }

  /**
   * Adds a thing, or counts it if an equal one is there.
   *
   * @param initial the count of the first one, 0 or 1
   */
  Added add(K key, long initial) {
    AtomicLong fresh = new AtomicLong(initial);
    while (counts.mappingCount() < most) {
      AtomicLong present = counts.putIfAbsent(key, fresh);
      if (present == null) {
        return Added.FIRST;
      }
      if (present.incrementAndGet() > 0) {
        return Added.COUNTED;
      }
      boolean unused = counts.remove(key, present);
    }
    return count(key) ? Added.COUNTED : Added.FULL;
  }

  /** Takes all counts above 0, and forgets the things that were not counted since the last call. */
  List<Counted<K>> take() {
    List<Counted<K>> taken = new ArrayList<>();
    counts.forEach(
        (key, count) -> {
          long value = count.getAndSet(0);
          if (value > 0) {
            taken.add(new Counted<>(key, value));
          } else if (count.compareAndSet(0, RETIRED)) {
            boolean unused = counts.remove(key, count);
          }
        });
    return taken;
  }
}
