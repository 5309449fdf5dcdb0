package org.dfra.river.filter;

import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** The elements of a stream that it may refer back to, by their handles. */
final class HandleTable {

  private static final long UNFINISHED = 0;
  private static final int FEW = 16;

  private final Map<Integer, ClassDescriptor> forms = new HashMap<>();
  private final BitSet references = new BitSet();
  private long[] costs = {};
  private int size;

  /** Elements that have begun and not ended, the innermost last; some may have been aborted. */
  private int[] open = {};

  private int opened;

  /** Removes everything: handles start at 0 again. */
  void clear() {
    size = 0;
    opened = 0;
    forms.clear();
    references.clear();
  }

  /** The number of handles, which is the next handle. */
  int size() {
    return size;
  }

  /** Assigns a handle to an element that begins. */
  int assign() {
    if (size == costs.length) {
      costs = Arrays.copyOf(costs, Math.max(FEW, 2 * size));
    }
    costs[size] = UNFINISHED;
    if (opened == open.length) {
      open = Arrays.copyOf(open, Math.max(FEW, 2 * opened));
    }
    open[opened++] = size;
    return size++;
  }

  private void close(int handle) {
    while (opened > 0 && open[opened - 1] >= handle) { // later ones were aborted
      opened--;
    }
  }

  /**
   * Whether an element has not ended and is not the one that is being read now. Such an element
   * need not contain itself, since the reference in it that leads here may never be followed.
   */
  boolean isEnclosing(int handle) {
    return !forms.containsKey(handle) && costs[handle] == UNFINISHED && open[opened - 1] != handle;
  }

  /** Records the traversal cost of an element that has ended; returns that cost. */
  long finish(int handle, long cost) {
    close(handle);
    costs[handle] = cost;
    return cost;
  }

  /** The traversal cost of a reference to an element. */
  long cost(int handle) {
    if (forms.containsKey(handle)) {
      return TraversalCost.LEAF;
    }
    return costs[handle] == UNFINISHED ? TraversalCost.CYCLIC : costs[handle];
  }

  /** Records the description of a class. */
  void describe(int handle, ClassDescriptor form) {
    close(handle);
    forms.put(handle, form);
  }

  /** A class; null for other elements, or if its description has not ended. */
  @Nullable ClassDescriptor form(int handle) {
    return forms.get(handle);
  }

  /** Records that a string may be the type of a reference field. */
  void markReferenceType(int handle) {
    references.set(handle);
  }

  /** Whether an element is a string that may be the type of a reference field. */
  boolean isReferenceType(int handle) {
    return references.get(handle);
  }
}
