package org.dfra.river.filter;

import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** What a stream has had so far and may refer back to, by the numbers that it has there. */
final class HandleTable {

  private static final long UNFINISHED = 0;

  private final Map<Integer, ClassForm> forms = new HashMap<>();
  private final BitSet references = new BitSet();
  private long[] costs = new long[64];
  private int size;

  /** Forgets everything: numbers begin with 0 again. */
  void clear() {
    size = 0;
    forms.clear();
    references.clear();
  }

  /** How many numbers there are, which is the next. */
  int size() {
    return size;
  }

  /** Numbers something that begins. */
  int assign() {
    if (size == costs.length) {
      costs = Arrays.copyOf(costs, 2 * size);
    }
    costs[size] = UNFINISHED;
    return size++;
  }

  /** Notes what something costs that has come to its end; that cost. */
  long finish(int handle, long cost) {
    costs[handle] = cost;
    return cost;
  }

  /** What it costs to refer to something. */
  long cost(int handle) {
    if (forms.containsKey(handle)) {
      return Cost.LEAF;
    }
    return costs[handle] == UNFINISHED ? Cost.ENDLESS : costs[handle];
  }

  /** Notes that a class has been described. */
  void describe(int handle, ClassForm form) {
    forms.put(handle, form);
  }

  /** A class; null where there is something else, or its description has not come to its end. */
  @Nullable ClassForm form(int handle) {
    return forms.get(handle);
  }

  /** Notes that a string may be the type of a field that is a reference. */
  void nameReference(int handle) {
    references.set(handle);
  }

  /** Whether something is a string that may be the type of a field that is a reference. */
  boolean namesReference(int handle) {
    return references.get(handle);
  }
}
