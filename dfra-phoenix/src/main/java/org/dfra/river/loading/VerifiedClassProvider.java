package org.dfra.river.loading;

import java.io.IOException;
import java.rmi.server.RMIClassLoaderSpi;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.dfra.river.filter.ClassLookup;
import org.jspecify.annotations.Nullable;

/**
 * The class provider of RMI, and so of River: classes come from the local class path first, then
 * from the codebase of the object, if that is trusted.
 *
 * <p>It is installed by {@link TrustedCode#install()} or {@code
 * -Djava.rmi.server.RMIClassLoaderSpi=org.dfra.river.loading.VerifiedClassProvider}. It needs no
 * security manager. River's own provider loads from a codebase only under a security manager, and
 * then from any codebase.
 */
public final class VerifiedClassProvider extends RMIClassLoaderSpi {

  private static final Set<String> PRIMITIVES =
      Set.of("boolean", "byte", "char", "short", "int", "long", "float", "double", "void");

  private static final DynamicProxyClassCache PROXIES = new DynamicProxyClassCache();

  private final @Nullable VerifiedLoaderCache given;

  /** Called by the JDK: uses the trust of {@link TrustedCode}. */
  public VerifiedClassProvider() {
    given = null;
    TrustedCode.markInstalled();
  }

  /** Uses the given trust. */
  public VerifiedClassProvider(CodeTrust trust) {
    given = new VerifiedLoaderCache(new CodebaseVerifier(trust), System::nanoTime);
  }

  /**
   * {@inheritDoc}
   *
   * @throws ClassNotFoundException if it is not on the class path and its codebase is refused (the
   *     cause is a {@link CodeRefusedException}), cannot be fetched, or does not contain it
   */
  @Override
  public Class<?> loadClass(
      @Nullable String codebase, String name, @Nullable ClassLoader defaultLoader)
      throws ClassNotFoundException {
    if (PRIMITIVES.contains(name)) {
      throw new ClassNotFoundException(name + " is a primitive type, not a class");
    }
    for (ClassLoader local : local(defaultLoader)) {
      try {
        return ClassLookup.find(name, local);
      } catch (ClassNotFoundException e) {
        // another codebase may have it
      }
    }
    return find(name, downloaded(codebase, name));
  }

  private static Class<?> find(String name, ClassLoader loader) throws ClassNotFoundException {
    if (loader instanceof VerifiedLoader verified && !ClassLookup.exists(name, loader)) {
      throw verified.missing(name);
    }
    return ClassLookup.find(name, loader);
  }

  /**
   * {@inheritDoc}
   *
   * @throws ClassNotFoundException as {@link #loadClass} does, or if the interfaces fit no proxy
   */
  @Override
  public Class<?> loadProxyClass(
      @Nullable String codebase, String[] interfaces, @Nullable ClassLoader defaultLoader)
      throws ClassNotFoundException {
    for (ClassLoader local : local(defaultLoader)) {
      try {
        return proxyClass(interfaces, local);
      } catch (ClassNotFoundException e) {
        // another codebase may have them
      }
    }
    return proxyClass(interfaces, downloaded(codebase, "a proxy of " + Arrays.asList(interfaces)));
  }

  /**
   * {@inheritDoc}
   *
   * @throws CodeRefusedException if the codebase is not trusted or cannot be fetched
   */
  @Override
  public ClassLoader getClassLoader(@Nullable String codebase) {
    if (codebase == null || codebase.isBlank()) {
      return context();
    }
    try {
      return loaders().loader(codebase, context());
    } catch (CodeRefusedException e) {
      LoadingFaults.add(e);
      throw e;
    } catch (IOException e) {
      LoadingFaults.add(e);
      throw new CodeRefusedException(String.valueOf(e.getMessage()), e);
    }
  }

  /**
   * {@inheritDoc}
   *
   * <p>A downloaded class keeps the codebase it came from; a class of the class path has that of
   * its kind of module, or else the current value of system property {@code
   * java.rmi.server.codebase}; a class of the JDK has none.
   */
  @Override
  public @Nullable String getClassAnnotation(Class<?> type) {
    Class<?> element = type;
    while (element.isArray()) {
      element = element.getComponentType();
    }
    ClassLoader loader = element.getClassLoader();
    if (loader instanceof DynamicProxyClassCache.ProxyLoader) {
      loader = loader.getParent();
    }
    if (loader == null || loader == ClassLoader.getPlatformClassLoader()) {
      return null;
    }
    if (loader instanceof VerifiedLoader downloaded) {
      return downloaded.codebase();
    }
    return TrustedCode.annotation(element);
  }

  private ClassLoader downloaded(@Nullable String codebase, String what)
      throws ClassNotFoundException {
    if (codebase == null || codebase.isBlank()) {
      throw new ClassNotFoundException(
          what
              + " is not on the class path, and no codebase came with it; add its jar, or have its"
              + " sender serve one");
    }
    try {
      return loaders().loader(codebase, context());
    } catch (CodeRefusedException | IOException e) {
      LoadingFaults.add(e);
      throw new ClassNotFoundException(what + " was not loaded: " + e.getMessage(), e);
    }
  }

  private VerifiedLoaderCache loaders() throws IOException {
    return given != null ? given : TrustedCode.loaders();
  }

  private static Set<ClassLoader> local(@Nullable ClassLoader defaultLoader) {
    Set<ClassLoader> local = new LinkedHashSet<>();
    if (defaultLoader != null) {
      local.add(defaultLoader);
    }
    local.add(context());
    return local;
  }

  private static ClassLoader context() {
    ClassLoader context = Thread.currentThread().getContextClassLoader();
    return context == null ? ClassLoader.getSystemClassLoader() : context;
  }

  private static Class<?> proxyClass(String[] names, ClassLoader loader)
      throws ClassNotFoundException {
    List<Class<?>> interfaces = new ArrayList<>();
    for (String name : names) {
      interfaces.add(find(name, loader));
    }
    try {
      return PROXIES.get(interfaces, loader);
    } catch (IllegalArgumentException e) {
      throw new ClassNotFoundException(
          String.join(", ", names)
              + " cannot be implemented by one proxy ("
              + e.getMessage()
              + "); see that its parts come from one class loader",
          e);
    }
  }
}
