package org.dfra.river.loading;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.lang.ref.ReferenceQueue;
import java.lang.ref.WeakReference;
import java.lang.reflect.Modifier;
import java.lang.reflect.Proxy;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.WeakHashMap;
import org.jspecify.annotations.Nullable;

/**
 * The classes of proxies whose interfaces another computer named.
 *
 * <p>A class lives as long as its loader, and there are more combinations of interfaces than a
 * virtual machine can have classes. So each combination is defined in a loader of its own, and its
 * class can be unloaded when the last proxy of it is gone. While there is one, equal combinations
 * have the same class.
 *
 * <p>A proxy of an interface that is not public can only be defined by the loader of that
 * interface. At most {@value #MAX_UNLOADABLE} such combinations are defined in this virtual
 * machine.
 *
 * <p>Thread-safe.
 */
final class DynamicProxyClassCache {

  static final int MAX_UNLOADABLE = 256;

  /** By the loader that finds the interfaces, and their names. */
  @GuardedBy("this")
  private final Map<ClassLoader, Map<List<String>, DefinedClass>> defined = new WeakHashMap<>();

  private final ReferenceQueue<Class<?>> unloaded = new ReferenceQueue<>();

  @GuardedBy("this")
  private int unloadable;

  /** Does not keep the class loaded. */
  private static final class DefinedClass extends WeakReference<Class<?>> {

    private final List<String> interfaces;
    private final WeakReference<ClassLoader> finder;

    DefinedClass(
        Class<?> type,
        ReferenceQueue<Class<?>> queue,
        List<String> interfaces,
        ClassLoader finder) {
      super(type, queue);
      this.interfaces = interfaces;
      this.finder = new WeakReference<>(finder);
    }
  }

  /** Defines one proxy class. */
  static final class ProxyLoader extends ClassLoader {
    ProxyLoader(ClassLoader interfaces) {
      super("proxy", interfaces);
    }
  }

  /**
   * The class of a proxy.
   *
   * @param interfaces found by {@code finder}
   * @param finder the loader that found them
   * @throws ClassNotFoundException if no more proxies of non-public interfaces are defined
   * @throws IllegalArgumentException if one proxy cannot implement these interfaces
   */
  synchronized Class<?> get(List<Class<?>> interfaces, ClassLoader finder)
      throws ClassNotFoundException {
    removeUnloaded();
    Map<List<String>, DefinedClass> known =
        defined.computeIfAbsent(finder, unused -> new HashMap<>());
    List<String> names = interfaces.stream().map(Class::getName).toList();
    @Nullable DefinedClass before = known.get(names);
    @Nullable Class<?> type = before == null ? null : before.get();
    if (type == null) {
      type = define(interfaces, finder);
      known.put(names, new DefinedClass(type, unloaded, names, finder));
    }
    return type;
  }

  @GuardedBy("this")
  private Class<?> define(List<Class<?>> interfaces, ClassLoader finder)
      throws ClassNotFoundException {
    for (Class<?> each : interfaces) {
      if (!Modifier.isPublic(each.getModifiers())) {
        if (unloadable == MAX_UNLOADABLE) {
          throw new ClassNotFoundException(
              "a proxy of "
                  + each.getName()
                  + ": this virtual machine has received "
                  + MAX_UNLOADABLE
                  + " kinds of proxies whose interfaces are not public; make the interface public");
        }
        Class<?> type = proxyClass(each.getClassLoader(), interfaces);
        unloadable++;
        return type;
      }
    }
    return proxyClass(new ProxyLoader(finder), interfaces);
  }

  @GuardedBy("this")
  private void removeUnloaded() {
    for (Object each = unloaded.poll(); each != null; each = unloaded.poll()) {
      DefinedClass gone = (DefinedClass) each;
      @Nullable ClassLoader finder = gone.finder.get();
      @Nullable Map<List<String>, DefinedClass> known = finder == null ? null : defined.get(finder);
      if (known != null) {
        boolean unused = known.remove(gone.interfaces, gone); // not one that was defined since
      }
    }
  }

  @SuppressWarnings("deprecation") // the stream needs the class; the instance is created elsewhere
  private static Class<?> proxyClass(@Nullable ClassLoader definer, List<Class<?>> interfaces) {
    return Proxy.getProxyClass(definer, interfaces.toArray(Class<?>[]::new));
  }
}
