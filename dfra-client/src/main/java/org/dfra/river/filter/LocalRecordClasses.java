package org.dfra.river.filter;

import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Determines which of the classes that one stream describes are records in this virtual machine, as
 * far as its own class loader and that of the thread's context know them. Classes are found, not
 * initialized.
 */
final class LocalRecordClasses {

  /**
   * Maximum number of unknown classes, whose look-up takes longest; legitimate streams have a few.
   */
  static final int UNKNOWN = 64;

  private final Map<String, Boolean> known = new HashMap<>();
  private int unknown;

  /**
   * Whether a class is a record here.
   *
   * @param name its name; empty for a proxy
   * @throws RefusedDataException if too many are unknown here
   */
  boolean contains(String name) {
    if (name.isEmpty() || name.startsWith("java.")) {
      return false;
    }
    @Nullable Boolean before = known.get(name);
    if (before != null) {
      return before;
    }
    boolean isRecord =
        isRecord(name, LocalRecordClasses.class.getClassLoader())
            || isRecord(name, Thread.currentThread().getContextClassLoader());
    known.put(name, isRecord);
    return isRecord;
  }

  private boolean isRecord(String name, @Nullable ClassLoader loader) {
    try {
      return ClassLookup.find(name, loader).isRecord();
    } catch (ClassNotFoundException | LinkageError e) { // an unknown class
      unknown++;
      if (unknown > 2 * UNKNOWN) { // there are two loaders
        throw new RefusedDataException(
            "refused to read on: more than "
                + UNKNOWN
                + " classes that are not known here; send fewer kinds of objects");
      }
      return false;
    }
  }
}
