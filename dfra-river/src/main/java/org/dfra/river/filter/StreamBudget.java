package org.dfra.river.filter;

/** Compares what one stream has used up with its limits. */
final class StreamBudget {

  /** An honest key is a string, an identity, or a record of a few. */
  static final int STEPS_PER_ENTRY = 16;

  private final SerialLimits limits;
  private long references;
  private long claimed;
  private long heap;
  private long entries;
  private long hashed;

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
  void build(long bytes) {
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
    build(HeapSize.array(element, length));
  }

  /** Counts an entry of a hash table, whose key has this {@link Cost}. */
  void hash(long key) {
    entries++;
    limits.checkTables(entries);
    hashed += Cost.steps(key);
    long steps = STEPS_PER_ENTRY * Math.min(limits.tableEntries(), Integer.MAX_VALUE);
    SerialLimits.atMost(hashed, steps, "steps to hash keys", "dfra.serial.table");
    build(HeapSize.TABLE_ENTRY);
  }
}
