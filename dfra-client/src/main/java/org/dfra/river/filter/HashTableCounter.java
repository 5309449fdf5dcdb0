package org.dfra.river.filter;

import java.util.ArrayDeque;
import java.util.Deque;

/**
 * Counts the hash tables of one stream, as far as a filter sees them.
 *
 * <p>Before {@code HashMap}, {@code HashSet}, {@code LinkedHashMap}, {@code LinkedHashSet}, {@code
 * Hashtable} and {@code Properties} create their table, they have the filter check an array of
 * {@code Map.Entry} with its capacity, at the depth of the table itself. The contents of the table
 * are read at a greater depth, and the next object after the table begins with a check at its depth
 * or a smaller one. So a table counts as open until a check at its depth or less: adjacent tables
 * are never nested, and a table inside another always is.
 *
 * <p>To a filter, a reference back to an earlier table looks like any other reference. {@link
 * StreamScanner}, which reads the bytes, follows those too.
 */
final class HashTableCounter {

  /** Nested tables: a table of tables is allowed, and no more. */
  static final int MAX_NESTING = 2;

  private final SerialLimits limits;
  private final Deque<Long> open = new ArrayDeque<>(1); // depths, the innermost first
  private long capacity;

  HashTableCounter(SerialLimits limits) {
    this.limits = limits;
  }

  /** Records that another object is read at this depth. */
  void reached(long depth) {
    while (!open.isEmpty() && depth <= open.element()) {
      open.remove();
    }
  }

  /**
   * Counts a table when its check arrives.
   *
   * @param depth of the table
   * @param buckets its capacity
   * @throws RefusedDataException if it is nested too deeply or there are too many entries
   */
  void opened(long depth, long buckets) {
    if (limits.tableEntries() == Long.MAX_VALUE) {
      return;
    }
    reached(depth);
    checkNesting(open.size() + 1L);
    capacity += buckets;
    limits.checkTables(capacity);
    open.push(depth);
  }

  /**
   * Checks against {@link #MAX_NESTING}.
   *
   * @throws RefusedDataException if there are more
   */
  static void checkNesting(long nested) {
    if (nested > MAX_NESTING) {
      throw new RefusedDataException(
          "refused to read on: "
              + nested
              + " hash tables in one another > "
              + MAX_NESTING
              + " allowed; send lists or records instead");
    }
  }
}
