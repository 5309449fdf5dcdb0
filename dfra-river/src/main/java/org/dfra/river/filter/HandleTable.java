package org.dfra.river.filter;

import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** What a stream has had so far and may refer back to, by the numbers that it has there. */
final class HandleTable {

  private static final long UNFINISHED = 0;

  private final Map<Integer, ClassDescriptor> forms = new HashMap<>();
  private final BitSet references = new BitSet();
  private long[] costs = new long[64];
  private int size;

  /** What has begun and not come to its end, the innermost last; some may have been aborted. */
  private int[] open = new int[32];

  private int opened;

  /** Forgets everything: numbers begin with 0 again. */
  void clear() {
    size = 0;
    opened = 0;
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
    if (opened == open.length) {
      open = Arrays.copyOf(open, 2 * opened);
    }
    open[opened++] = size;
    return size++;
  }

  private void close(int handle) {
    while (opened > 0 && open[opened - 1] >= handle) { // those after it were aborted
      opened--;
    }
  }

  /**
   * Whether something has not come to its end and is not what is being read just now: it need not
   * contain itself, since nobody may follow the reference in it that leads here.
   */
  boolean isEnclosing(int handle) {
    return !forms.containsKey(handle) && costs[handle] == UNFINISHED && open[opened - 1] != handle;
  }

  /** Notes what something costs that has come to its end; that cost. */
  long finish(int handle, long cost) {
    close(handle);
    costs[handle] = cost;
    return cost;
  }

  /** What it costs to refer to something. */
  long cost(int handle) {
    if (forms.containsKey(handle)) {
      return TraversalCost.LEAF;
    }
    return costs[handle] == UNFINISHED ? TraversalCost.CYCLIC : costs[handle];
  }

  /** Notes that a class has been described. */
  void describe(int handle, ClassDescriptor form) {
    close(handle);
    forms.put(handle, form);
  }

  /** A class; null where there is something else, or its description has not come to its end. */
  @Nullable ClassDescriptor form(int handle) {
    return forms.get(handle);
  }

  /** Notes that a string may be the type of a field that is a reference. */
  void markReferenceType(int handle) {
    references.set(handle);
  }

  /** Whether something is a string that may be the type of a field that is a reference. */
  boolean isReferenceType(int handle) {
    return references.get(handle);
  }
}
