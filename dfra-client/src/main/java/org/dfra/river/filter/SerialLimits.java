package org.dfra.river.filter;

import java.io.ObjectInputFilter.FilterInfo;
import java.util.Properties;

/**
 * The size limits of a serialized object graph.
 *
 * @param depth depth of nested objects
 * @param references objects and back references in one stream
 * @param bytes bytes of one stream, and bytes that its arrays may claim together
 * @param arrayLength elements of one array
 * @param heap heap bytes of all objects of one stream, as {@link HeapSize} estimates them
 * @param tableEntries entries of all hash tables of one stream together. Keys with equal hash codes
 *     cost its square
 */
public record SerialLimits(
    long depth, long references, long bytes, long arrayLength, long heap, long tableEntries) {

  /** For the arguments of one call: DFRA's own calls have no hash tables. */
  public static final SerialLimits CALL =
      new SerialLimits(24, 200_000, 8 << 20, 4 << 20, 16 << 20, 2_048);

  /**
   * For every other stream from the network, results too: a registrar may answer with thousands of
   * services.
   */
  public static final SerialLimits STREAM =
      new SerialLimits(24, 4_000_000, 64 << 20, 4 << 20, 160 << 20, 16_384);

  /**
   * For the response of unicast discovery, which any host may send. That of a robot's registrar has
   * 2 kB.
   */
  public static final SerialLimits DISCOVERY_RESPONSE =
      new SerialLimits(24, 4_096, 64 << 10, 64 << 10, 1 << 20, 256);

  /**
   * For the report of a phoenix that was requested to stop its effectors, which any program may
   * send. That of a thousand effectors has about 150 kB.
   */
  public static final SerialLimits STOP_REPORT =
      new SerialLimits(24, 65_536, 1 << 20, 4_096, 8 << 20, 64);

  /** For data that this host wrote itself, such as phoenix's journal or a registrar's snapshot. */
  public static final SerialLimits STORED =
      new SerialLimits(
          24, Long.MAX_VALUE, Long.MAX_VALUE, 16 << 20, Long.MAX_VALUE, Long.MAX_VALUE);

  public SerialLimits {
    if (depth < 1
        || references < 1
        || bytes < 1
        || arrayLength < 1
        || heap < 1
        || tableEntries < 1) {
      throw new IllegalArgumentException(
          "a limit below 1: depth "
              + depth
              + ", references "
              + references
              + ", bytes "
              + bytes
              + ", array length "
              + arrayLength
              + ", heap "
              + heap
              + ", table entries "
              + tableEntries);
    }
  }

  /**
   * Replaces the limits that are set.
   *
   * @param properties {@code dfra.serial.depth}, {@code .references}, {@code .bytes}, {@code
   *     .array}, {@code .heap} and {@code .table}
   * @throws IllegalArgumentException if one is not a whole number above 0
   */
  SerialLimits with(Properties properties) {
    return new SerialLimits(
        number(properties, "depth", depth),
        number(properties, "references", references),
        number(properties, "bytes", bytes),
        number(properties, "array", arrayLength),
        number(properties, "heap", heap),
        number(properties, "table", tableEntries));
  }

  private static long number(Properties properties, String name, long otherwise) {
    String key = "dfra.serial." + name;
    String text = properties.getProperty(key);
    if (text == null) {
      return otherwise;
    }
    try {
      long number = Long.parseLong(text.trim());
      if (number >= 1) {
        return number;
      }
    } catch (NumberFormatException e) {
      // reported below
    }
    throw new IllegalArgumentException(
        key + " = \"" + text + "\" is not a whole number above 0; correct the system property");
  }

  /**
   * Checks a stream's progress against the limits.
   *
   * @throws RefusedDataException if it exceeds one of them
   */
  void check(FilterInfo info) {
    atMost(info.depth(), depth, "objects nested", "dfra.serial.depth");
    atMost(info.references(), references, "objects", "dfra.serial.references");
    atMost(info.streamBytes(), bytes, "bytes", "dfra.serial.bytes");
    atMost(info.arrayLength(), arrayLength, "elements in one array", "dfra.serial.array");
  }

  /**
   * Checks the heap size of a stream's objects against the limit.
   *
   * @param built bytes on the heap
   * @throws RefusedDataException if it is larger
   */
  void checkHeap(long built) {
    atMost(built, heap, "bytes on the heap", "dfra.serial.heap");
  }

  /**
   * Checks the hash tables of a stream against the limit.
   *
   * @param entries of all of them together
   * @throws RefusedDataException if there are more
   */
  void checkTables(long entries) {
    atMost(entries, tableEntries, "entries of hash tables", "dfra.serial.table");
  }

  static void atMost(long seen, long allowed, String what, String key) {
    if (seen > allowed) {
      throw new RefusedDataException(
          "refused to read on: "
              + seen
              + " "
              + what
              + " > "
              + allowed
              + " allowed; send less, or raise "
              + key
              + " where it is read");
    }
  }
}
