package org.dfra.river.filter;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectStreamConstants;
import java.io.StreamCorruptedException;
import java.util.ArrayList;
import java.util.List;
import org.dfra.river.filter.ClassDescriptor.HashTableKind;
import org.jspecify.annotations.Nullable;

/**
 * Reads the bytes of an object stream one element at a time and checks them before an object stream
 * deserializes anything: depth, objects, bytes on the heap, and hash tables.
 *
 * <p>A filter of the JDK cannot bound the cost of hash tables. It sees neither strings, nor which
 * objects are keys, nor the target of a back reference. The hash code of an object that refers
 * twice to an object that refers twice to another, and so on, takes two to the power of their
 * number of steps. Here all of that is known. {@link TraversalCost} follows back references. All
 * keys together may cost as many steps as there may be entries, times {@link
 * StreamBudget#STEPS_PER_ENTRY}. An object that is not a key may be compared or printed later, so a
 * walk through the whole stream is bounded too.
 *
 * <p>An element is a block of primitive data or an object with everything that it refers to. It is
 * stored until it has arrived completely: a call that stalls costs the bytes that it has sent, not
 * the lengths that its arrays declare. Source: Java Object Serialization Specification, chapter 6.
 */
final class StreamScanner implements ObjectStreamConstants {

  /** Characters that are compared in one step, approximately. */
  private static final int CHARACTERS_PER_STEP = 16;

  private static final int HEADER = 4;
  private static final String ENDPOINT = "net.jini.jeri.BasicObjectEndpoint";

  /**
   * A marshalled object contains a stream, which is checked on arrival, not when it is
   * unmarshalled.
   */
  private static final int STREAMS_IN_ONE_ANOTHER = 8;

  private final ElementBuffer in;
  private final SerialLimits limits;
  private final StreamBudget budget;
  private final HandleTable handles = new HandleTable();
  private final LocalRecordClasses records = new LocalRecordClasses();
  private final ProxyKinds proxies;
  private final int level;
  private boolean begun;
  private boolean aborting;
  private int depth;

  /**
   * @param in an object stream from its first byte
   */
  StreamScanner(InputStream in, SerialLimits limits) {
    this(in, limits, new ProxyKinds(), 1);
  }

  private StreamScanner(InputStream in, SerialLimits limits, ProxyKinds proxies, int level) {
    this.in = new ElementBuffer(in);
    this.limits = limits;
    this.budget = new StreamBudget(limits);
    this.proxies = proxies;
    this.level = level;
  }

  /** The bytes of the last element. */
  ElementBuffer element() {
    return in;
  }

  /**
   * Reads the next element.
   *
   * @return whether there was one
   * @throws RefusedDataException if it exceeds a limit
   * @throws StreamCorruptedException if it is not an element of an object stream
   */
  boolean next() throws IOException {
    in.clear();
    if (!begun) {
      begun = true;
      in.read(HEADER);
      return true;
    }
    if (!in.readIfAvailable()) {
      return false;
    }
    int tag = in.at(0);
    try {
      if (tag == TC_RESET) {
        reset();
      } else if (!isBlock(tag)) {
        budget.countTraversal(content(tag));
      }
    } catch (AbortedException e) { // the element ends with the exception that the writer got
      depth = 0; // its handles continue, as they do for an object stream
    }
    return true;
  }

  /** An object that the writer could not write; its exception was sent instead. */
  private static final class AbortedException extends IOException {
    private static final long serialVersionUID = 1L;
  }

  private void reset() {
    handles.clear();
    depth = 0;
  }

  /** Reads a block of primitive data, if this tag begins one. */
  private boolean isBlock(int tag) throws IOException {
    if (tag == TC_BLOCKDATA) {
      in.read(in.unsignedByte());
      return true;
    }
    if (tag == TC_BLOCKDATALONG) {
      in.read(ElementBuffer.length(in.integer()));
      return true;
    }
    return false;
  }

  /** Reads an object of any kind; returns its traversal cost. */
  private long content() throws IOException {
    return content(in.unsignedByte());
  }

  private long content(int tag) throws IOException {
    depth++;
    budget.reference();
    long cost =
        switch (tag) {
          case TC_NULL -> TraversalCost.LEAF;
          case TC_REFERENCE -> referred(reference());
          case TC_STRING -> string(in.unsignedShort());
          case TC_LONGSTRING -> string(ElementBuffer.length(in.longInteger()));
          case TC_OBJECT -> object();
          case TC_ARRAY -> array();
          case TC_ENUM -> constant();
          case TC_CLASS -> named();
          case TC_CLASSDESC, TC_PROXYCLASSDESC -> {
            ClassDescriptor unused = describe(tag);
            yield TraversalCost.LEAF;
          }
          case TC_EXCEPTION -> throw aborted();
          default -> throw new StreamCorruptedException("an object begins with tag " + tag);
        };
    depth--;
    return cost;
  }

  private AbortedException aborted() throws IOException {
    if (aborting) { // no writer does that, and it could overflow this thread's stack
      throw new StreamCorruptedException("an exception of the writer in another one");
    }
    aborting = true;
    reset();
    long unused = content();
    aborting = false;
    return new AbortedException();
  }

  /** Reads the handle of an earlier element. */
  private int reference() throws IOException {
    int handle = in.integer() - baseWireHandle;
    if (handle < 0 || handle >= handles.size()) {
      throw new StreamCorruptedException("a reference back to number " + handle);
    }
    return handle;
  }

  private long string(long bytes) throws IOException {
    int handle = handles.assign();
    budget.countHeap(HeapSize.string(bytes));
    in.read(bytes);
    if (bytes > 0 && !HeapSize.isPrimitive((char) in.at(in.size() - (int) bytes))) {
      handles.markReferenceType(handle);
    }
    return handles.finish(handle, TraversalCost.of(1 + bytes / CHARACTERS_PER_STEP, 0));
  }

  private long constant() throws IOException {
    budget.depth(depth);
    ClassDescriptor unused = form();
    int handle = handles.assign();
    long unusedName = content();
    return handles.finish(handle, TraversalCost.LEAF);
  }

  private long named() throws IOException {
    budget.depth(depth);
    ClassDescriptor unused = form();
    return handles.finish(handles.assign(), TraversalCost.LEAF);
  }

  private long referred(int handle) {
    if (handles.isEnclosing(handle)) {
      budget.countEnclosingReference();
    }
    return handles.cost(handle);
  }

  private long array() throws IOException {
    budget.depth(depth);
    ClassDescriptor form = form();
    int handle = handles.assign();
    int length = in.integer();
    if (form == null || length < 0) {
      throw new StreamCorruptedException("an array of " + length + " elements of no class");
    }
    char element = form.elementTypeCode();
    budget.array(element, length);
    if (HeapSize.isPrimitive(element)) {
      in.read((long) length * HeapSize.width(element));
      if (element == 'B') {
        marshalled(length);
      }
      return handles.finish(handle, TraversalCost.of(1L + length, 0));
    }
    long cost = TraversalCost.LEAF;
    for (int i = 0; i < length; i++) {
      cost = TraversalCost.sum(cost, content());
    }
    return handles.finish(handle, cost);
  }

  /** Checks the last bytes, if they begin like an object stream. */
  private void marshalled(int length) throws IOException {
    DataInputStream bytes = new DataInputStream(in.last(length));
    if (length < HEADER
        || bytes.readShort() != STREAM_MAGIC
        || bytes.readShort() != STREAM_VERSION) {
      return;
    }
    if (level == STREAMS_IN_ONE_ANOTHER) {
      throw new RefusedDataException(
          "refused to read on: marshalled objects in one another, more than "
              + STREAMS_IN_ONE_ANOTHER
              + "; send them beside each other");
    }
    StreamScanner scanner = new StreamScanner(in.last(length), limits, proxies, level + 1);
    try {
      boolean goesOn = true;
      while (goesOn) {
        goesOn = scanner.next();
      }
    } catch (IOException e) {
      RefusedDataException refusal =
          new RefusedDataException(
              "refused to read on: bytes that begin as an object stream are none: "
                  + e.getMessage());
      refusal.initCause(e);
      throw refusal;
    }
  }

  private long object() throws IOException {
    budget.depth(depth);
    ClassDescriptor form = form();
    int handle = handles.assign();
    if (form == null) {
      throw new StreamCorruptedException("an object of no class");
    }
    if (form.has(SC_EXTERNALIZABLE)) {
      return handles.finish(handle, external(form));
    }
    long cost = TraversalCost.LEAF;
    for (ClassDescriptor part : form.classHierarchy()) {
      cost = TraversalCost.sum(cost, data(part));
    }
    return handles.finish(handle, cost);
  }

  /** Reads the data of an externalizable object; returns its traversal cost. */
  private long external(ClassDescriptor form) throws IOException {
    if (!form.has(SC_BLOCK_DATA)) {
      throw new StreamCorruptedException(
          form.name() + " is written by the first version of the protocol, without its length");
    }
    budget.countHeap(HeapSize.SMALL_OBJECT);
    return annotation(HashTableKind.NONE);
  }

  /** Reads the data of one class of an object's lineage; returns its traversal cost. */
  private long data(ClassDescriptor form) throws IOException {
    budget.countHeap(HeapSize.object(form.primitiveBytes(), form.references()));
    in.read(form.primitiveBytes());
    boolean flag = form.primitiveBytes() > 0 && in.at(in.size() - 1) != 0;
    if (form.name().equals(ENDPOINT) && (flag || form.primitiveBytes() > 1)) {
      throw new RefusedDataException(
          "refused to read a remote reference with distributed garbage collection: to read it"
              + " starts a thread and opens a connection; export the object without, as"
              + " BasicJeriExporter does by default");
    }
    HashTableKind table = form.hashTableKind(form.primitiveBytes() > 0 ? in.at(in.size() - 1) : 0);
    long cost = TraversalCost.LEAF;
    for (int i = 0; i < form.references(); i++) {
      cost = TraversalCost.sum(cost, content());
    }
    return form.has(SC_WRITE_METHOD) ? TraversalCost.sum(cost, annotation(table)) : cost;
  }

  /**
   * Reads the data that a class has written by itself, to its end: blocks and objects. Returns its
   * traversal cost.
   */
  private long annotation(HashTableKind table) throws IOException {
    long sum = TraversalCost.LEAF;
    int count = 0;
    for (int tag = in.unsignedByte(); tag != TC_ENDBLOCKDATA; tag = in.unsignedByte()) {
      if (isBlock(tag)) {
        continue;
      }
      long cost = content(tag);
      sum = TraversalCost.sum(sum, cost);
      if (table == HashTableKind.SET || (table == HashTableKind.MAP && count % 2 == 0)) {
        budget.countKey(cost);
      }
      count++;
    }
    if (table == HashTableKind.NONE) {
      return sum;
    }
    long nested = TraversalCost.nesting(sum) + 1;
    HashTableCounter.checkNesting(nested);
    return TraversalCost.nested(sum, nested);
  }

  /** Reads a class descriptor or a reference back to one; null for none. */
  private @Nullable ClassDescriptor form() throws IOException {
    int tag = in.unsignedByte();
    if (tag == TC_NULL) {
      return null;
    }
    if (tag == TC_REFERENCE) {
      @Nullable ClassDescriptor known = handles.form(reference());
      if (known == null) {
        throw new StreamCorruptedException("a reference back to a class that was not described");
      }
      return known;
    }
    return describe(tag);
  }

  private ClassDescriptor describe(int tag) throws IOException {
    budget.reference();
    budget.depth(depth);
    int handle = handles.assign();
    if (tag == TC_PROXYCLASSDESC) {
      int count = ElementBuffer.length(in.integer());
      List<String> interfaces = new ArrayList<>();
      for (int i = 0; i < count; i++) {
        interfaces.add(in.name());
      }
      proxies.count(interfaces);
      return described(handle, "", SC_SERIALIZABLE, 0, 0);
    }
    if (tag != TC_CLASSDESC) {
      throw new StreamCorruptedException("a class descriptor begins with tag " + tag);
    }
    String name = in.name();
    in.read(Long.BYTES);
    int flags = in.unsignedByte();
    int fields = (short) in.unsignedShort();
    if (fields < 0) { // an object stream treats that as none
      throw new StreamCorruptedException(name + " with " + fields + " fields");
    }
    ClassDescriptor.check(name, flags, fields);
    long primitives = 0;
    int others = 0;
    for (int i = 0; i < fields; i++) {
      char code = (char) in.unsignedByte();
      in.read(in.unsignedShort());
      if (!HeapSize.isPrimitive(code)) {
        others++;
        type();
      } else if (ClassDescriptor.PRIMITIVES.indexOf(code) >= 0) {
        primitives += HeapSize.width(code);
      } else {
        throw new StreamCorruptedException(name + " with a field of type " + code);
      }
    }
    return described(handle, name, flags, primitives, others);
  }

  /** Reads the type of a reference field: a back reference to another value would be accepted. */
  private void type() throws IOException {
    int tag = in.unsignedByte();
    int handle = handles.size();
    if (tag == TC_REFERENCE) {
      handle = reference();
    } else if (tag == TC_STRING || tag == TC_LONGSTRING) {
      long unused = content(tag);
    }
    if (!handles.isReferenceType(handle)) {
      throw new StreamCorruptedException("a field that is a reference has another type");
    }
  }

  /** Reads the rest of a descriptor: annotation and parent. */
  private ClassDescriptor described(int handle, String name, int flags, long primitives, int others)
      throws IOException {
    long unused = annotation(HashTableKind.NONE);
    depth++;
    ClassDescriptor form = new ClassDescriptor(name, flags, primitives, others, form());
    depth--;
    form.check(records);
    handles.describe(handle, form);
    return form;
  }
}
