package org.dfra.river.filter;

import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectStreamConstants;
import java.io.StreamCorruptedException;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.dfra.river.filter.ClassForm.Table;
import org.jspecify.annotations.Nullable;

/**
 * Reads the bytes of an object stream one element at a time and judges them before an object stream
 * builds anything: depth, objects, bytes on the heap, and hash tables.
 *
 * <p>A filter of the JDK cannot bound what hash tables cost. It sees neither strings, nor which
 * objects are keys, nor where a reference back leads, and an object that refers twice to one that
 * refers twice to another, and so on, has a hash code that takes two to the power of their number
 * to compute. Here all of that is known. {@link Cost} follows references back; keys may cost as
 * many steps together as there may be entries, times {@link #STEPS_PER_ENTRY}.
 *
 * <p>An element is a block of primitive data or an object with all that it refers to. It is kept
 * until it has come as a whole: a call that stalls costs the bytes that it has sent, not what its
 * arrays announce. Source: Java Object Serialization Specification, chapter 6.
 */
final class StreamScanner implements ObjectStreamConstants {

  /** An honest key is a string, an identity, or a record of a few. */
  static final int STEPS_PER_ENTRY = 16;

  /** Characters that are compared in one step, about. */
  private static final int CHARACTERS_PER_STEP = 16;

  private static final int HEADER = 4;
  private static final long UNFINISHED = 0;
  private static final String ENDPOINT = "net.jini.jeri.BasicObjectEndpoint";

  /** Classes of the JDK that read themselves without their fields, so none may be described. */
  private static final Set<String> WITHOUT_FIELDS =
      Set.of(
          "java.rmi.activation.ActivationID",
          "java.util.concurrent.LinkedTransferQueue",
          "javax.security.auth.x500.X500Principal");

  private final RecordedInput in;
  private final SerialLimits limits;
  private final Map<Integer, ClassForm> forms = new HashMap<>(); // by handle
  private long[] costs = new long[64]; // by handle
  private int handles;
  private boolean begun;
  private boolean aborting;
  private int depth;
  private long references;
  private long claimed;
  private long heap;
  private long entries;
  private long hashed;

  /**
   * @param in an object stream from its first byte
   */
  StreamScanner(InputStream in, SerialLimits limits) {
    this.in = new RecordedInput(in);
    this.limits = limits;
  }

  /** The bytes of the last element. */
  RecordedInput element() {
    return in;
  }

  /**
   * Reads the next element.
   *
   * @return whether there was one
   * @throws RefusedDataException if it is beyond a limit
   * @throws StreamCorruptedException if it is no element of an object stream
   */
  boolean next() throws IOException {
    in.clear();
    if (!begun) {
      begun = true;
      in.take(HEADER);
      return true;
    }
    if (!in.takeIfAny()) {
      return false;
    }
    int tag = in.at(0);
    try {
      if (tag == TC_RESET) {
        reset();
      } else if (!isBlock(tag)) {
        content(tag);
      }
    } catch (AbortedException e) { // the element ends with what went wrong at the writer
      reset();
    }
    return true;
  }

  /** What the writer could not write; its exception has come instead. */
  private static final class AbortedException extends IOException {
    private static final long serialVersionUID = 1L;
  }

  private void reset() {
    handles = 0;
    forms.clear();
    depth = 0;
  }

  /** Reads a block of primitive data, if this tag begins one. */
  private boolean isBlock(int tag) throws IOException {
    if (tag == TC_BLOCKDATA) {
      in.take(in.unsignedByte());
      return true;
    }
    if (tag == TC_BLOCKDATALONG) {
      in.take(length(in.integer()));
      return true;
    }
    return false;
  }

  /** Reads an object of any kind; what it costs. */
  private long content() throws IOException {
    return content(in.unsignedByte());
  }

  private long content(int tag) throws IOException {
    depth++;
    references++;
    SerialLimits.atMost(references, limits.references(), "objects", "dfra.serial.references");
    long cost =
        switch (tag) {
          case TC_NULL -> Cost.LEAF;
          case TC_REFERENCE -> referred();
          case TC_STRING -> string(in.unsignedShort());
          case TC_LONGSTRING -> string(length(in.longInteger()));
          case TC_OBJECT -> object();
          case TC_ARRAY -> array();
          case TC_ENUM -> constant();
          case TC_CLASS -> named();
          case TC_CLASSDESC, TC_PROXYCLASSDESC -> {
            ClassForm unused = describe(tag);
            yield Cost.LEAF;
          }
          case TC_EXCEPTION -> throw aborted();
          default -> throw new StreamCorruptedException("an object begins with tag " + tag);
        };
    depth--;
    return cost;
  }

  private AbortedException aborted() throws IOException {
    if (aborting) { // no writer does that, and it could go on beyond this thread's stack
      throw new StreamCorruptedException("an exception of the writer in another one");
    }
    aborting = true;
    reset();
    long unused = content();
    aborting = false;
    return new AbortedException();
  }

  private void checkDepth() {
    SerialLimits.atMost(depth, limits.depth(), "objects nested", "dfra.serial.depth");
  }

  private long referred() throws IOException {
    int handle = in.integer() - baseWireHandle;
    if (handle < 0 || handle >= handles) {
      throw new StreamCorruptedException("a reference back to number " + handle);
    }
    return forms.containsKey(handle)
        ? Cost.LEAF
        : costs[handle] == UNFINISHED ? Cost.ENDLESS : costs[handle];
  }

  private int assign() {
    if (handles == costs.length) {
      costs = Arrays.copyOf(costs, 2 * handles);
    }
    costs[handles] = UNFINISHED;
    return handles++;
  }

  private long finish(int handle, long cost) {
    costs[handle] = cost;
    return cost;
  }

  private void build(long bytes) {
    heap += bytes;
    limits.checkHeap(heap);
  }

  private long string(long bytes) throws IOException {
    int handle = assign();
    build(HeapSize.string(bytes));
    in.take(bytes);
    return finish(handle, Cost.of(1 + bytes / CHARACTERS_PER_STEP, 0));
  }

  private long constant() throws IOException {
    checkDepth();
    ClassForm unused = form();
    int handle = assign();
    long unusedName = content();
    return finish(handle, Cost.LEAF);
  }

  private long named() throws IOException {
    checkDepth();
    ClassForm unused = form();
    return finish(assign(), Cost.LEAF);
  }

  private long array() throws IOException {
    checkDepth();
    ClassForm form = form();
    int handle = assign();
    int length = in.integer();
    if (form == null || form.name().length() < 2 || length < 0) {
      throw new StreamCorruptedException("an array of " + length + " elements of no class");
    }
    SerialLimits.atMost(length, limits.arrayLength(), "elements in one array", "dfra.serial.array");
    char element = form.name().charAt(1);
    int width = HeapSize.width(element);
    claimed += (long) length * width;
    SerialLimits.atMost(claimed, limits.bytes(), "bytes claimed by arrays", "dfra.serial.bytes");
    build(HeapSize.array(element, length));
    if (HeapSize.isPrimitive(element)) {
      in.take((long) length * width);
      return finish(handle, Cost.of(1L + length, 0));
    }
    long cost = Cost.LEAF;
    for (int i = 0; i < length; i++) {
      cost = Cost.sum(cost, content());
    }
    return finish(handle, cost);
  }

  private long object() throws IOException {
    checkDepth();
    ClassForm form = form();
    int handle = assign();
    if (form == null) {
      throw new StreamCorruptedException("an object of no class");
    }
    if (form.has(SC_EXTERNALIZABLE)) {
      return finish(handle, external(form));
    }
    long cost = Cost.LEAF;
    for (ClassForm part : form.lineage()) {
      cost = Cost.sum(cost, data(part));
    }
    return finish(handle, cost);
  }

  /** What an object has written that writes all of itself. */
  private long external(ClassForm form) throws IOException {
    if (!form.has(SC_BLOCK_DATA)) {
      throw new StreamCorruptedException(
          form.name() + " is written by the first version of the protocol, without its length");
    }
    build(HeapSize.SMALL_OBJECT);
    return annotation(Table.NONE);
  }

  /** What one class of an object's lineage has written. */
  private long data(ClassForm form) throws IOException {
    build(HeapSize.object(form.primitiveBytes(), form.references()));
    in.take(form.primitiveBytes());
    boolean flag = form.primitiveBytes() > 0 && in.at(in.size() - 1) != 0;
    if (form.name().equals(ENDPOINT) && (flag || form.primitiveBytes() > 1)) {
      throw new RefusedDataException(
          "refused to read a remote reference with distributed garbage collection: to read it"
              + " starts a thread and opens a connection; export the object without, as"
              + " BasicJeriExporter does by default");
    }
    Table table = form.table(form.primitiveBytes() > 0 ? in.at(in.size() - 1) : 0);
    long cost = Cost.LEAF;
    for (int i = 0; i < form.references(); i++) {
      cost = Cost.sum(cost, content());
    }
    return form.has(SC_WRITE_METHOD) ? Cost.sum(cost, annotation(table)) : cost;
  }

  /** What a class has written by itself, to its end: blocks and objects. */
  private long annotation(Table table) throws IOException {
    long sum = Cost.LEAF;
    int count = 0;
    for (int tag = in.unsignedByte(); tag != TC_ENDBLOCKDATA; tag = in.unsignedByte()) {
      if (isBlock(tag)) {
        continue;
      }
      long cost = content(tag);
      sum = Cost.sum(sum, cost);
      if (table == Table.SET || (table == Table.MAP && count % 2 == 0)) {
        hash(cost);
      }
      count++;
    }
    if (table == Table.NONE) {
      return sum;
    }
    long nested = Cost.nesting(sum) + 1;
    HashTables.checkNesting(nested);
    return Cost.of(Cost.steps(sum), nested);
  }

  private void hash(long key) {
    entries++;
    limits.checkTables(entries);
    hashed += Cost.steps(key);
    long steps = STEPS_PER_ENTRY * Math.min(limits.tableEntries(), Integer.MAX_VALUE);
    SerialLimits.atMost(hashed, steps, "steps to hash keys", "dfra.serial.table");
    build(HeapSize.TABLE_ENTRY);
  }

  /** Reads a class descriptor or a reference back to one; null for none. */
  private @Nullable ClassForm form() throws IOException {
    int tag = in.unsignedByte();
    if (tag == TC_NULL) {
      return null;
    }
    if (tag == TC_REFERENCE) {
      ClassForm known = forms.get(in.integer() - baseWireHandle);
      if (known == null) {
        throw new StreamCorruptedException("a reference back to a class that was not described");
      }
      return known;
    }
    return describe(tag);
  }

  private ClassForm describe(int tag) throws IOException {
    references++;
    checkDepth();
    int handle = assign();
    if (tag == TC_PROXYCLASSDESC) {
      int interfaces = length(in.integer());
      for (int i = 0; i < interfaces; i++) {
        in.take(in.unsignedShort());
      }
      return described(handle, "", SC_SERIALIZABLE, 0, 0);
    }
    if (tag != TC_CLASSDESC) {
      throw new StreamCorruptedException("a class descriptor begins with tag " + tag);
    }
    String name = in.name();
    in.take(Long.BYTES);
    int flags = in.unsignedByte();
    int fields = in.unsignedShort();
    if (fields > 0 && WITHOUT_FIELDS.contains(name)) {
      throw new StreamCorruptedException(name + " with fields, which it never reads");
    }
    long primitives = 0;
    int others = 0;
    for (int i = 0; i < fields; i++) {
      char code = (char) in.unsignedByte();
      in.take(in.unsignedShort());
      if (HeapSize.isPrimitive(code)) {
        primitives += HeapSize.width(code);
      } else {
        others++;
        long unused = content();
      }
    }
    return described(handle, name, flags, primitives, others);
  }

  /** Reads the rest of a descriptor: annotation and parent. */
  private ClassForm described(int handle, String name, int flags, long primitives, int others)
      throws IOException {
    long unused = annotation(Table.NONE);
    depth++;
    ClassForm form = new ClassForm(name, flags, primitives, others, form());
    depth--;
    forms.put(handle, form);
    return form;
  }

  private static int length(long announced) throws StreamCorruptedException {
    if (announced < 0 || announced > Integer.MAX_VALUE) {
      throw new StreamCorruptedException("a length of " + announced);
    }
    return (int) announced;
  }
}
