package org.dfra.river.filter;

import java.io.ObjectStreamConstants;
import java.io.StreamCorruptedException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * The description of a class in a stream.
 *
 * @param name its name; empty for a proxy
 * @param flags how its objects are written, see {@link ObjectStreamConstants}
 * @param primitiveBytes bytes of its primitive fields
 * @param references number of its reference fields
 * @param parent its superclass, or null if that is not serializable
 */
record ClassDescriptor(
    String name, int flags, long primitiveBytes, int references, @Nullable ClassDescriptor parent) {

  /** The position of a hash table's entries in the data of a class. */
  enum HashTableKind {
    /** Not a hash table. */
    NONE,
    /** Each object is hashed. */
    SET,
    /** Each second object is hashed, including the first. */
    MAP
  }

  /** Type codes of primitive types. */
  static final String PRIMITIVES = "BCDFIJSZ";

  /**
   * Classes of the JDK that read their own data without their fields. They must not declare fields,
   * and their data must be marked as their own; otherwise they would read the data of another
   * object.
   */
  private static final Set<String> WITHOUT_FIELDS =
      Set.of(
          "java.rmi.activation.ActivationID",
          "java.rmi.server.RemoteObject",
          "java.util.Date",
          "java.util.concurrent.LinkedTransferQueue",
          "javax.security.auth.x500.X500Principal");

  /** Flags that a record never has. */
  private static final int NO_RECORD =
      ObjectStreamConstants.SC_WRITE_METHOD | ObjectStreamConstants.SC_EXTERNALIZABLE;

  /**
   * A list, a set or a map of {@code List.of} and similar methods; its one field gives the kind.
   */
  private static final String IMMUTABLE = "java.util.CollSer";

  private static final int IMMUTABLE_SET = 2;
  private static final int IMMUTABLE_MAP = 3;

  /**
   * Checks the beginning of a description.
   *
   * @param fields number of fields
   * @throws StreamCorruptedException if an object stream would read objects of this class
   *     differently from the description
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
   * Checks a complete description.
   *
   * @throws StreamCorruptedException if its class is a record here, of which an object stream reads
   *     only the fields, and the description contains more
   */
  void check(LocalRecordClasses records) throws StreamCorruptedException {
    if ((has(NO_RECORD) || parent != null) && records.contains(name)) {
      throw new StreamCorruptedException(name + " is a record, and has more than its fields");
    }
  }

  /**
   * The type code of an array's elements.
   *
   * @throws StreamCorruptedException if it is not an array: an object stream would read objects of
   *     it
   */
  char elementTypeCode() throws StreamCorruptedException {
    char code = name.length() > 1 && name.charAt(0) == '[' ? name.charAt(1) : ' ';
    if (HeapSize.isPrimitive(code) && (name.length() > 2 || PRIMITIVES.indexOf(code) < 0)) {
      throw new StreamCorruptedException("an array of class " + name + ", which is none");
    }
    return code;
  }

  /** Whether any of these bits is set. */
  boolean has(int flag) {
    return (flags & flag) != 0;
  }

  /** This class and its superclasses, the topmost first, in the order of their data in a stream. */
  Deque<ClassDescriptor> classHierarchy() {
    Deque<ClassDescriptor> classHierarchy = new ArrayDeque<>();
    for (ClassDescriptor form = this; form != null; form = form.parent) {
      classHierarchy.push(form);
    }
    return classHierarchy;
  }

  /**
   * The kind of hash table of the objects of this class.
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
      return HashTableKind.SET; // it is unknown which field gives the kind: all may be hashed
    }
    return switch (number) {
      case IMMUTABLE_SET -> HashTableKind.SET;
      case IMMUTABLE_MAP -> HashTableKind.MAP;
      default -> HashTableKind.NONE;
    };
  }
}
