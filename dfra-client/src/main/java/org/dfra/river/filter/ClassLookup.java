package org.dfra.river.filter;

import java.lang.ref.WeakReference;
import java.util.Collections;
import java.util.Map;
import java.util.WeakHashMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;

/**
 * Finds classes by names that another computer sent.
 *
 * <p>For each name that it is asked for, {@link Class#forName} leaves an entry in the class loader
 * (its table of locks for parallel loading), also where there is no such class, and nothing removes
 * it. So invented names would fill the heap. Here, the file of a class is looked for first. Classes
 * that were found are remembered as long as their loader exists; they are not more than there are
 * files. So each is resolved once for each loader, and not again in each call.
 *
 * <p>The JDK's own loaders also remember each file that they do not have, until memory is almost
 * exhausted. So after {@value #MAX_MISSES} names without a class, {@link ClassFiles} looks for
 * files without these loaders, which takes longer at first and leaves nothing.
 *
 * <p>Thread-safe.
 */
public final class ClassLookup {

  /** The limit of dimensions of an array: each dimension is a class of its own, for ever. */
  static final int MAX_DIMENSIONS = 16;

  /** The limit of characters of a name; a longer one is refused without a look. */
  static final int MAX_CHARACTERS = 1024;

  /** So many names without a class are asked of the JDK's loaders. */
  static final int MAX_MISSES = 1000;

  private static final String PRIMITIVES = "ZBCSIJFD";

  private static final AtomicInteger MISSES = new AtomicInteger();

  private static final ClassFiles FILES =
      new ClassFiles(
          System.getProperty("java.class.path"), System.getProperty("dfra.boot-class-path"));

  /**
   * By the loader that is asked, the names of the classes that have a file, and the class if it was
   * asked for. Neither keeps a loader: the class may be of this loader itself.
   */
  private static final Map<ClassLoader, Map<String, WeakReference<Class<?>>>> FOUND =
      Collections.synchronizedMap(new WeakHashMap<>());

  private static final WeakReference<Class<?>> NOT_ASKED_FOR = new WeakReference<>(null);

  private ClassLookup() {}

  /**
   * Finds a class without initializing it, as {@link Class#forName(String, boolean, ClassLoader)}
   * does.
   *
   * @param name its binary name; that of an array as {@link Class#getName} writes it
   * @param loader null for that of the JDK's base classes
   * @throws ClassNotFoundException if the loader has no class of the name, or the name has more
   *     than 1024 characters or is that of an array with more than 16 dimensions
   */
  public static Class<?> find(String name, @Nullable ClassLoader loader)
      throws ClassNotFoundException {
    @Nullable Class<?> known = loader == null ? null : known(name, loader);
    if (known != null) {
      return known;
    }
    if (!exists(name, loader)) {
      throw new ClassNotFoundException(name);
    }
    Class<?> found = Class.forName(name, false, loader);
    if (loader != null && !found.isArray()) { // there are more names of arrays than classes
      found(loader).put(name, new WeakReference<>(found));
    }
    return found;
  }

  /** A class that the loader was asked for before: it gives the same one for ever. */
  private static @Nullable Class<?> known(String name, ClassLoader loader) {
    @Nullable WeakReference<Class<?>> known = found(loader).get(name);
    return known == null ? null : known.get();
  }

  private static Map<String, WeakReference<Class<?>>> found(ClassLoader loader) {
    return FOUND.computeIfAbsent(loader, unused -> new ConcurrentHashMap<>());
  }

  /** Whether a loader has the file of a class, or of an array's elements. */
  public static boolean exists(String name, @Nullable ClassLoader loader) {
    if (name.length() > MAX_CHARACTERS) {
      return false;
    }
    int dimensions = 0;
    while (dimensions < name.length() && name.charAt(dimensions) == '[') {
      dimensions++;
    }
    if (dimensions > MAX_DIMENSIONS) {
      return false;
    }
    String element = name;
    if (dimensions > 0) {
      String code = name.substring(dimensions);
      if (code.length() == 1) {
        return PRIMITIVES.contains(code);
      }
      if (!code.startsWith("L") || !code.endsWith(";")) {
        return false;
      }
      element = code.substring(1, code.length() - 1);
    }
    if (loader == null) { // the virtual machine's own loader has no such table
      return true;
    }
    Map<String, WeakReference<Class<?>>> found = found(loader);
    if (found.containsKey(element)) {
      return true;
    }
    boolean exists = element.indexOf('/') < 0 && hasFile(loader, element.replace('.', '/'));
    if (exists) {
      WeakReference<Class<?>> unused = found.putIfAbsent(element, NOT_ASKED_FOR);
    }
    return exists;
  }

  private static boolean hasFile(ClassLoader loader, String path) {
    String file = path + ".class";
    if (MISSES.get() >= MAX_MISSES) {
      return FILES.has(file, loader);
    }
    boolean hasFile = loader.getResource(file) != null;
    if (!hasFile) {
      MISSES.incrementAndGet();
    }
    return hasFile;
  }
}
