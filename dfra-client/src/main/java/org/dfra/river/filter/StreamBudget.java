package org.dfra.river.filter;

/** Counts the resources that one stream uses and checks them against its limits. */
final class StreamBudget {

  /** A legitimate key is a string, an identity, or a record of a few. */
  static final int STEPS_PER_ENTRY = 16;

  /**
   * A walk around a cycle continues until its stack is full; not every object with a cycle is in
   * it.
   */
  private static final int ROUNDS = 16;

  /** Maximum number of doublings of the visits, which is more than any stream may have. */
  private static final int DOUBLINGS = 16;

  /** Visits beyond one for each byte on the heap; legitimate streams share few objects. */
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

  /** Checks the depth of nested objects. */
  void depth(int depth) {
    SerialLimits.atMost(depth, limits.depth(), "objects nested", "dfra.serial.depth");
  }

  /** Counts an object, a reference back, or a class. */
  void reference() {
    references++;
    SerialLimits.atMost(references, limits.references(), "objects", "dfra.serial.references");
  }

  /** Counts deserialized objects, in bytes on the heap. */
  void countHeap(long bytes) {
    heap += bytes;
    limits.checkHeap(heap);
  }

  /**
   * Counts an array, which may be allocated before its elements arrive.
   *
   * @param element the type code of its elements
   */
  void array(char element, int length) {
    SerialLimits.atMost(length, limits.arrayLength(), "elements in one array", "dfra.serial.array");
    claimed += (long) length * HeapSize.width(element);
    SerialLimits.atMost(claimed, limits.bytes(), "bytes claimed by arrays", "dfra.serial.bytes");
    countHeap(HeapSize.array(element, length));
  }

  /**
   * Counts a reference to an object around the one that is being read. Its cost is not yet known,
   * and may be as much as everything read by then.
   */
  void countEnclosingReference() {
    around = Math.min(around + 1, DOUBLINGS);
  }

  /** Counts the visits of a walk through an object with this {@link TraversalCost}. */
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
