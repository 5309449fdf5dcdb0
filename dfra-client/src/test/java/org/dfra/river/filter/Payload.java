package org.dfra.river.filter;

import static java.util.Objects.requireNonNull;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.ObjectOutputStream;
import java.io.ObjectStreamConstants;
import java.io.Serializable;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.Set;
import javax.management.BadAttributeValueExpException;
import org.dfra.river.fixture.TestCode;

/** Graphs that a stranger might send. Whatever of them runs while it is read says so. */
final class Payload {

  private static final String RAN = "elsewhere.ran";
  private static final String SOURCE =
      """
      package elsewhere;
      import java.io.*;
      import java.lang.reflect.*;
      public class Payload implements Serializable, java.util.Comparator<Object> {
        public static class Handler extends Payload implements InvocationHandler {
          public Object invoke(Object p, Method m, Object[] a) { return ran(0); }
        }
        public interface Kind {}
        public int compare(Object a, Object b) { return ran(0); }
        public int hashCode() { return ran(1); }
        private void readObject(ObjectInputStream in) { ran(0); }
        private Object readResolve() { ran(0); return this; }
        int ran(int value) { System.setProperty("elsewhere.ran", "yes"); return value; }
      }
      """;

  private final ClassLoader loader;

  /**
   * One whose classes nobody else has loaded.
   *
   * @param classes where {@link #compile} has put them
   */
  Payload(Path classes) {
    loader = new FolderLoader(classes);
  }

  /**
   * Compiles the payload's classes where no class path has them. It takes long, so a class of tests
   * does it once.
   *
   * @param folder where the class files go
   */
  static void compile(Path folder) throws IOException {
    TestCode.compile(folder, Map.of("elsewhere.Payload", SOURCE));
  }

  /** No URL class loader, whose classes River would annotate with a file: codebase. */
  private static final class FolderLoader extends ClassLoader {
    private final Path classes;

    FolderLoader(Path classes) {
      super(Payload.class.getClassLoader());
      this.classes = classes;
    }

    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
      try {
        byte[] bytes = Files.readAllBytes(classes.resolve(name.replace('.', '/') + ".class"));
        return defineClass(name, bytes, 0, bytes.length);
      } catch (IOException e) {
        throw new ClassNotFoundException(name, e);
      }
    }
  }

  /** Where its class can be found, as if it were on the victim's class path. */
  ClassLoader loader() {
    return loader;
  }

  /** An object of a class that is not allowed. */
  Object object() throws ReflectiveOperationException {
    return loader.loadClass("elsewhere.Payload").getConstructor().newInstance();
  }

  private InvocationHandler handler() throws ReflectiveOperationException {
    return (InvocationHandler)
        loader.loadClass("elsewhere.Payload$Handler").getConstructor().newInstance();
  }

  /** Whether any of it ran since the last {@link #reset}. */
  static boolean ran() {
    return System.getProperty(RAN) != null;
  }

  static void reset() {
    System.clearProperty(RAN);
  }

  /** Graphs by what they are, none of which may be built. */
  @SuppressWarnings("unchecked")
  Map<String, Object> gadgets() throws Exception {
    Map<String, Object> gadgets = new LinkedHashMap<>();
    gadgets.put("a foreign object", object());
    gadgets.put(
        "an array of a foreign class", java.lang.reflect.Array.newInstance(object().getClass(), 1));
    gadgets.put("a set that hashes", new HashSet<>(Set.of(object())));
    gadgets.put("a queue that compares", queue((Comparator<Object>) object()));
    gadgets.put(
        "a proxy with a foreign handler",
        Proxy.newProxyInstance(loader, new Class<?>[] {Runnable.class}, handler()));
    gadgets.put(
        "a proxy with the JDK's annotation handler",
        requireNonNull(Runnable.class.getAnnotation(FunctionalInterface.class)));
    gadgets.put("an exception that prints its value", new BadAttributeValueExpException("x"));
    gadgets.put("a lambda", (Runnable & Serializable) () -> {});
    gadgets.put("a URL", URI.create("http://host.invalid/").toURL());
    gadgets.put("a foreign class", object().getClass());
    return gadgets;
  }

  private static PriorityQueue<Object> queue(Comparator<Object> comparator) {
    PriorityQueue<Object> queue = new PriorityQueue<>(2, comparator);
    queue.add("a");
    queue.add("b");
    return queue;
  }

  /** Lists in lists. */
  static Object nested(int levels) {
    List<Object> list = new ArrayList<>();
    for (int i = 1; i < levels; i++) {
      list = new ArrayList<>(List.of(list));
    }
    return list;
  }

  /** Small to send; takes 2 to the power of its levels to read. */
  static Object bomb(int levels) {
    Set<Object> root = new HashSet<>();
    Set<Object> a = root;
    Set<Object> b = new HashSet<>();
    for (int i = 0; i < levels; i++) {
      Set<Object> nextA = new HashSet<>(Set.of("x"));
      Set<Object> nextB = new HashSet<>();
      a.addAll(List.of(nextA, nextB));
      b.addAll(List.of(nextA, nextB));
      a = nextA;
      b = nextB;
    }
    return root;
  }

  /** A stream that announces an array, and ends. */
  static byte[] array(String type, long serialVersion, int length) throws IOException {
    ByteArrayOutputStream bytes = header();
    DataOutputStream out = new DataOutputStream(bytes);
    out.writeByte(ObjectStreamConstants.TC_ARRAY);
    describe(out, type, serialVersion);
    out.writeInt(length);
    return bytes.toByteArray();
  }

  /** A stream with an object of a class that this virtual machine would not write. */
  static byte[] objectOf(String type, long serialVersion) throws IOException {
    ByteArrayOutputStream bytes = header();
    DataOutputStream out = new DataOutputStream(bytes);
    out.writeByte(ObjectStreamConstants.TC_OBJECT);
    describe(out, type, serialVersion);
    return bytes.toByteArray();
  }

  private static ByteArrayOutputStream header() throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    new DataOutputStream(bytes).writeInt(0xACED0005);
    return bytes;
  }

  private static void describe(DataOutputStream out, String type, long serialVersion)
      throws IOException {
    out.writeByte(ObjectStreamConstants.TC_CLASSDESC);
    out.writeUTF(type);
    out.writeLong(serialVersion);
    out.writeByte(ObjectStreamConstants.SC_SERIALIZABLE);
    out.writeShort(0);
    out.writeByte(ObjectStreamConstants.TC_ENDBLOCKDATA);
    out.writeByte(ObjectStreamConstants.TC_NULL);
  }

  static byte[] bytes(Object graph) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(graph);
    }
    return bytes.toByteArray();
  }
}
