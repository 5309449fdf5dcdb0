package org.dfra.river.filter;

/** Compares what one stream has used up with its limits. */
final class StreamBudget {

  /** An honest key is a string, an identity, or a record of a few. */
  static final int STEPS_PER_ENTRY = 16;

  /** Around a cycle a walk goes until its stack is full; not all that has one is in it. */
  private static final int ROUNDS = 16;

  /** So often the visits are doubled at the most, which is more than any stream may have. */
  private static final int DOUBLINGS = 16;

  /** Visits beyond one for each byte on the heap; of honest objects few are shared. */
  private static final long MORE_VISITS = 1 << 20;

  private final SerialLimits limits;
  private long references;
  private long claimed;
  private long heap;
  private long entries;
  private long hashed;
  private long walked;
  private int around;

  StreamBudget(SerialLimits limits) {
    this.limits = limits;
  }

  /** Compares how deep objects are in one another. */
  void depth(int depth) {
    SerialLimits.atMost(depth, limits.depth(), "objects nested", "dfra.serial.depth");
  }

  /** Counts an object, a reference back, or a class. */
  void reference() {
    references++;
    SerialLimits.atMost(references, limits.references(), "objects", "dfra.serial.references");
  }

  /** Counts what is built, in bytes on the heap. */
  void countHeap(long bytes) {
    heap += bytes;
    limits.checkHeap(heap);
  }

  /**
   * Counts an array, which may be made before its elements have come.
   *
   * @param element the type code of what it holds
   */
  void array(char element, int length) {
    SerialLimits.atMost(length, limits.arrayLength(), "elements in one array", "dfra.serial.array");
    claimed += (long) length * HeapSize.width(element);
    SerialLimits.atMost(claimed, limits.bytes(), "bytes claimed by arrays", "dfra.serial.bytes");
    countHeap(HeapSize.array(element, length));
  }

  /**
   * Counts a reference to an object around the one that is being read. What that costs is not known
   * yet, and may be as much as all that has come by then.
   */
  void countEnclosingReference() {
    around = Math.min(around + 1, DOUBLINGS);
  }

  /** Counts what a walk through an object visits that has this {@link TraversalCost}. */
  void countTraversal(long cost) {
    walked += (TraversalCost.visits(cost) * (TraversalCost.isCyclic(cost) ? ROUNDS : 1)) << around;
    long most = heap + MORE_VISITS;
    if (walked > most && limits.heap() < Long.MAX_VALUE) {
      throw new RefusedDataException(
          "refused to read on: "
              + walked
              + " objects, each as often as it is referred to, > "
              + most
              + " allowed; refer to the same object less often");
    }
  }

  /** Counts an entry of a hash table, whose key has this {@link TraversalCost}. */
  void countKey(long key) {
    entries++;
    limits.checkTables(entries);
    hashed += TraversalCost.steps(key);
    long steps = STEPS_PER_ENTRY * Math.min(limits.tableEntries(), Integer.MAX_VALUE);
    SerialLimits.atMost(hashed, steps, "steps to hash keys", "dfra.serial.table");
    countHeap(HeapSize.TABLE_ENTRY);
  }
}
