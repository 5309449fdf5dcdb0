package org.dfra.river.filter;

import java.io.ObjectStreamConstants;
import java.io.StreamCorruptedException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Set;
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
record ClassDescriptor(
    String name, int flags, long primitiveBytes, int references, @Nullable ClassDescriptor parent) {

  /** Where the entries of a hash table lie in what a class writes. */
  enum HashTableKind {
    /** It is none. */
    NONE,
    /** Each object is hashed. */
    SET,
    /** Each second object is hashed, the first of them too. */
    MAP
  }

  /** Type codes of primitive types. */
  static final String PRIMITIVES = "BCDFIJSZ";

  /**
   * Classes of the JDK that read themselves without their fields. So none may be described, and
   * what they read must be marked as their own: they would go on in what is another object's.
   */
  private static final Set<String> WITHOUT_FIELDS =
      Set.of(
          "java.rmi.activation.ActivationID",
          "java.rmi.server.RemoteObject",
          "java.util.Date",
          "java.util.concurrent.LinkedTransferQueue",
          "javax.security.auth.x500.X500Principal");

  /** How a record is never written. */
  private static final int NO_RECORD =
      ObjectStreamConstants.SC_WRITE_METHOD | ObjectStreamConstants.SC_EXTERNALIZABLE;

  /** A list, a set or a map of {@code List.of} and its like; its one field says which. */
  private static final String IMMUTABLE = "java.util.CollSer";

  private static final int IMMUTABLE_SET = 2;
  private static final int IMMUTABLE_MAP = 3;

  /**
   * Checks the beginning of a description.
   *
   * @param fields how many there are
   * @throws StreamCorruptedException if an object stream would read objects of this class otherwise
   *     than it says
   */
  static void check(String name, int flags, int fields) throws StreamCorruptedException {
    if (!WITHOUT_FIELDS.contains(name)) {
      return;
    }
    if (fields > 0) {
      throw new StreamCorruptedException(name + " with fields, which it never reads");
    }
    if ((flags & ObjectStreamConstants.SC_WRITE_METHOD) == 0) {
      throw new StreamCorruptedException(name + " without data of its own, which it always reads");
    }
  }

  /**
   * Checks a description as a whole.
   *
   * @throws StreamCorruptedException if its class is a record here, of which an object stream reads
   *     the fields and nothing else, and the description says more
   */
  void check(LocalRecordClasses records) throws StreamCorruptedException {
    if ((has(NO_RECORD) || parent != null) && records.contains(name)) {
      throw new StreamCorruptedException(name + " is a record, and has more than its fields");
    }
  }

  /**
   * The type code of an array's elements.
   *
   * @throws StreamCorruptedException if it is no array: an object stream would read objects of it
   */
  char elementTypeCode() throws StreamCorruptedException {
    char code = name.length() > 1 && name.charAt(0) == '[' ? name.charAt(1) : ' ';
    if (HeapSize.isPrimitive(code) && (name.length() > 2 || PRIMITIVES.indexOf(code) < 0)) {
      throw new StreamCorruptedException("an array of class " + name + ", which is none");
    }
    return code;
  }

  /** With any of these bits. */
  boolean has(int flag) {
    return (flags & flag) != 0;
  }

  /** This class and those it extends, the outermost first, as a stream has their data. */
  Deque<ClassDescriptor> lineage() {
    Deque<ClassDescriptor> lineage = new ArrayDeque<>();
    for (ClassDescriptor form = this; form != null; form = form.parent) {
      lineage.push(form);
    }
    return lineage;
  }

  /**
   * What kind of hash table the objects of this class are.
   *
   * @param collectionTag the lowest byte of the last of its primitive fields
   */
  HashTableKind hashTableKind(int collectionTag) {
    return switch (name) {
      case "java.util.HashSet" -> HashTableKind.SET;
      case "java.util.HashMap", "java.util.Hashtable", "java.util.concurrent.ConcurrentHashMap" ->
          HashTableKind.MAP;
      case IMMUTABLE -> immutable(collectionTag);
      default -> HashTableKind.NONE;
    };
  }

  private HashTableKind immutable(int number) {
    if (primitiveBytes != Integer.BYTES) {
      return HashTableKind.SET; // which of the fields says it is unknown: all may be hashed
    }
    return switch (number) {
      case IMMUTABLE_SET -> HashTableKind.SET;
      case IMMUTABLE_MAP -> HashTableKind.MAP;
      default -> HashTableKind.NONE;
    };
  }
}
