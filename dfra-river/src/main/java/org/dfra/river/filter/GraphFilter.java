package org.dfra.river.filter;

import java.io.ObjectInputFilter;

/**
 * Judges one stream: limits first, then every class it names. It counts, so each stream has its
 * own, and it is used by the thread that reads.
 */
final class GraphFilter implements ObjectInputFilter {

  private static final System.Logger LOG = System.getLogger(GraphFilter.class.getName());

  private final SerialLimits limits;
  private final AllowedTypes types;
  private long claimed;

  GraphFilter(SerialLimits limits, AllowedTypes types) {
    this.limits = limits;
    this.types = types;
  }

  @Override
  public Status checkInput(FilterInfo info) {
    try {
      limits.check(info);
      Class<?> type = info.serialClass();
      if (type == null) {
        return Status.UNDECIDED;
      }
      types.check(type);
      if (info.arrayLength() >= 0 && type.isArray()) {
        claim(type.getComponentType(), info.arrayLength());
      }
      return Status.ALLOWED;
    } catch (RefusedDataException e) {
      LOG.log(System.Logger.Level.WARNING, e.getMessage());
      throw e; // the stream rejects and makes it the cause
    }
  }

  /** An array is made before its elements have come: together they may claim what may come. */
  private void claim(Class<?> element, long length) {
    claimed += length * bytes(element);
    SerialLimits.atMost(claimed, limits.bytes(), "bytes claimed by arrays", "dfra.serial.bytes");
  }

  /** What an element takes in the stream at least. */
  private static int bytes(Class<?> element) {
    if (element == long.class || element == double.class) {
      return Long.BYTES;
    }
    if (element == int.class || element == float.class) {
      return Integer.BYTES;
    }
    return element == short.class || element == char.class ? Short.BYTES : 1;
  }
}
