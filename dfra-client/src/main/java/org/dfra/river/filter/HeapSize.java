package org.dfra.river.filter;

/**
 * Estimates the heap size of the objects of a stream, in bytes, as an upper bound: a header of 16
 * bytes, 8 bytes for a reference, sizes rounded up to multiples of 8. A virtual machine with
 * compressed references uses less.
 */
final class HeapSize {

  /** One reference. */
  static final long REFERENCE = 8;

  /** An object with one field; used for objects with unknown fields. */
  static final long SMALL_OBJECT = 24;

  /** An entry of a hash table: its node, and its share of the table. */
  static final long TABLE_ENTRY = 64;

  private static final long HEADER = 16;

  private HeapSize() {}

  /**
   * The size of an object.
   *
   * @param primitiveBytes bytes of its primitive fields
   * @param references number of its reference fields
   */
  static long object(long primitiveBytes, long references) {
    return rounded(HEADER + primitiveBytes + REFERENCE * references);
  }

  /**
   * The size of an array.
   *
   * @param element its element type, by its type code in class names: {@code B}, {@code L}, ...
   * @param length number of elements
   */
  static long array(char element, long length) {
    long width = isPrimitive(element) ? width(element) : REFERENCE;
    return rounded(HEADER + width * length);
  }

  /**
   * The size of a string.
   *
   * @param bytes its length in a stream
   */
  static long string(long bytes) {
    return SMALL_OBJECT + rounded(HEADER + bytes);
  }

  /** Whether a type code stands for a primitive type. */
  static boolean isPrimitive(char code) {
    return code != 'L' && code != '[';
  }

  /**
   * The size of a value in a stream, at least one for a reference.
   *
   * @param code its type code in class names
   */
  static int width(char code) {
    return switch (code) {
      case 'J', 'D' -> Long.BYTES;
      case 'I', 'F' -> Integer.BYTES;
      case 'S', 'C' -> Short.BYTES;
      default -> 1;
    };
  }

  private static long rounded(long bytes) {
    return (bytes + 7) / 8 * 8;
  }
}
