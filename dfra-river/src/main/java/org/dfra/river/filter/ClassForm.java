package org.dfra.river.filter;

import java.io.ObjectStreamConstants;
import java.util.ArrayDeque;
import java.util.Deque;
import org.jspecify.annotations.Nullable;

/**
 * A class as a stream describes it.
 *
 * @param name its name; empty for a proxy's
 * @param flags how its objects are written, see {@link ObjectStreamConstants}
 * @param primitiveBytes bytes of its primitive fields
 * @param references its fields that are references
 * @param parent the class it extends, or null where that is not serializable
 */
record ClassForm(
    String name, int flags, long primitiveBytes, int references, @Nullable ClassForm parent) {

  /** Where the entries of a hash table lie in what a class writes. */
  enum Table {
    /** It is none. */
    NONE,
    /** Each object is hashed. */
    SET,
    /** Each second object is hashed, the first of them too. */
    MAP
  }

  /** A list, a set or a map of {@code List.of} and its like; its one field says which. */
  private static final String IMMUTABLE = "java.util.CollSer";

  private static final int IMMUTABLE_SET = 2;
  private static final int IMMUTABLE_MAP = 3;

  /** With the bits of a flag. */
  boolean has(int flag) {
    return (flags & flag) != 0;
  }

  /** This class and those it extends, the outermost first, as a stream has their data. */
  Deque<ClassForm> lineage() {
    Deque<ClassForm> lineage = new ArrayDeque<>();
    for (ClassForm form = this; form != null; form = form.parent) {
      lineage.push(form);
    }
    return lineage;
  }

  /**
   * What kind of hash table the objects of this class are.
   *
   * @param number the lowest byte of the last of its primitive fields
   */
  Table table(int number) {
    return switch (name) {
      case "java.util.HashSet" -> Table.SET;
      case "java.util.HashMap", "java.util.Hashtable", "java.util.concurrent.ConcurrentHashMap" ->
          Table.MAP;
      case IMMUTABLE -> immutable(number);
      default -> Table.NONE;
    };
  }

  private Table immutable(int number) {
    if (primitiveBytes != Integer.BYTES) {
      return Table.SET; // which of the fields says it is unknown: all may be hashed
    }
    return switch (number) {
      case IMMUTABLE_SET -> Table.SET;
      case IMMUTABLE_MAP -> Table.MAP;
      default -> Table.NONE;
    };
  }
}
