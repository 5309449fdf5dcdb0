package org.dfra.river.filter;

import java.io.ObjectInputFilter;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Checks one stream: limits first, then every class in it. It has counters, so each stream has its
 * own filter, which the reading thread uses.
 */
class ObjectGraphFilter implements ObjectInputFilter {

  private static final System.Logger LOG = System.getLogger(ObjectGraphFilter.class.getName());

  /**
   * Limit for arrays that are compared element by element during deserialization; legitimate
   * streams have few.
   */
  private static final int CONSTRAINTS = 64;

  private static final String CONSTRAINT_PACKAGE = "net.jini.core.constraint";

  private final SerialLimits limits;
  private final AllowedTypes types;
  private final HashTableCounter tables;
  private long claimed;
  private long arrays; // bytes on the heap

  ObjectGraphFilter(SerialLimits limits, AllowedTypes types) {
    this.limits = limits;
    this.types = types;
    this.tables = new HashTableCounter(limits);
  }

  @Override
  public final Status checkInput(FilterInfo info) {
    try {
      limits.check(info);
      limits.checkHeap(arrays + HeapSize.SMALL_OBJECT * info.references());
      @Nullable Class<?> type = info.serialClass();
      checkObject(type);
      if (type == null && info.arrayLength() >= 0) { // read as objects, whatever the type
        throw new RefusedDataException(
            "refused to read an array of a class that is not known here; put the class on the class"
                + " path where it is read");
      }
      if (type == null) {
        tables.reached(info.depth());
        return Status.UNDECIDED;
      }
      check(type);
      if (type == Map.Entry[].class && info.arrayLength() >= 0) {
        tables.opened(info.depth(), info.arrayLength());
        built(HeapSize.TABLE_ENTRY * info.arrayLength());
      } else {
        tables.reached(info.depth());
        if (info.arrayLength() >= 0 && type.isArray()) {
          claim(type.getComponentType(), info.arrayLength());
        }
      }
      return Status.ALLOWED;
    } catch (RefusedDataException e) {
      LOG.log(System.Logger.Level.WARNING, e.getMessage());
      throw e; // the stream rejects and uses it as the cause
    }
  }

  /**
   * Checks any object that is not primitive.
   *
   * @param type its class, or null for a reference back
   * @throws RefusedDataException if nothing may be read now
   */
  void checkObject(@Nullable Class<?> type) {}

  /**
   * Checks a class in the stream.
   *
   * @throws RefusedDataException if it may not be read
   */
  void check(Class<?> type) {
    types.check(type);
  }

  /**
   * Counts an array. It is allocated before its elements arrive, so all arrays together may claim
   * at most the size limit of the stream.
   */
  private void claim(Class<?> element, long length) {
    char code = element.descriptorString().charAt(0);
    claimed += length * HeapSize.width(code);
    SerialLimits.atMost(claimed, limits.bytes(), "bytes claimed by arrays", "dfra.serial.bytes");
    built(HeapSize.array(code, length));
    if (length > CONSTRAINTS && element.getName().startsWith(CONSTRAINT_PACKAGE + ".")) {
      throw new RefusedDataException(
          "refused to read on: "
              + length
              + " constraints in one array > "
              + CONSTRAINTS
              + " allowed; send fewer");
    }
  }

  private void built(long bytes) {
    arrays += bytes;
    limits.checkHeap(arrays);
  }
}
