package org.dfra.river.loading;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.nio.file.Path;
import java.rmi.server.RMIClassLoader;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Switches downloaded code on in this virtual machine, for code that is trusted.
 *
 * <p>A main calls {@link #install()} before it uses RMI or River, and gives {@link #options()} to
 * the virtual machines it starts. {@link #annotate} says where those that lack its classes find
 * them.
 */
public final class TrustedCode {

  private static final Logger LOG = LoggerFactory.getLogger(TrustedCode.class);

  private static final String PROVIDER = "java.rmi.server.RMIClassLoaderSpi";
  private static final String TAKEN =
      "RMI has another class provider already; call TrustedCode.install() first in main, or start"
          + " with -D"
          + PROVIDER
          + "="
          + VerifiedClassProvider.class.getName();
  private static final String CODEBASE_ONLY = "java.rmi.server.useCodebaseOnly";
  private static final String CODEBASE = "java.rmi.server.codebase";

  private static volatile boolean inPlace;
  private static volatile Map<String, String> kinds = Map.of();
  private static @Nullable VerifiedLoaderCache loaders; // guarded by the class

  private TrustedCode() {}

  /**
   * Makes {@link VerifiedClassProvider} RMI's class provider, with what {@link
   * CodeTrust#configured()} says. Doing it again does nothing.
   *
   * @throws IOException if the trust file makes no sense
   * @throws IllegalStateException if RMI has a class provider already
   */
  public static void install() throws IOException {
    install(CodeTrust.configured());
  }

  /**
   * The same with a trust of the caller's own.
   *
   * @throws IllegalStateException if RMI has a class provider already
   */
  public static synchronized void install(CodeTrust trust) {
    if (!installIfAbsent(trust)) {
      throw new IllegalStateException(TAKEN);
    }
  }

  /**
   * Does what {@link #install()} does for a program that did not, as a directory does before it
   * reads its first proxy. Where RMI has another class provider it says so in the log.
   *
   * @throws IOException if the trust file makes no sense
   */
  public static void installIfAbsent() throws IOException {
    if (!inPlace && !installIfAbsent(CodeTrust.configured())) {
      LOG.warn("Proxies of robots that serve their classes cannot be read: {}.", TAKEN);
    }
  }

  /** Whether our provider is RMI's now. */
  private static synchronized boolean installIfAbsent(CodeTrust trust) {
    if (inPlace && loaders != null) {
      return true;
    }
    System.setProperty(PROVIDER, VerifiedClassProvider.class.getName());
    // Codebases in streams count: it is the provider that decides which.
    System.setProperty(CODEBASE_ONLY, "false");
    loaders = new VerifiedLoaderCache(new CodebaseVerifier(trust), System::nanoTime);
    RMIClassLoader.getClassAnnotation(TrustedCode.class); // has the JDK make the provider now
    return inPlace;
  }

  /**
   * From now on classes of the class path leave this virtual machine annotated with this codebase.
   *
   * @param codebase what {@link ClassServer#codebase} says
   */
  public static void annotate(String codebase) {
    CodebaseUrl.parse(codebase);
    System.setProperty(CODEBASE, codebase);
  }

  /**
   * The same, where some classes have codebases of their own.
   *
   * @param codebase of all other classes of the class path; null for none
   * @param byClass codebases by the full names of classes
   */
  static void annotate(@Nullable String codebase, Map<String, String> byClass) {
    kinds = Map.copyOf(byClass);
    if (codebase != null) {
      annotate(codebase);
    }
  }

  /** With which codebase a class of the class path leaves this virtual machine; null for none. */
  static @Nullable String annotation(Class<?> type) {
    // A stub's class is made at run time; what its reader may lack are its interfaces.
    Stream<Class<?>> named =
        Proxy.isProxyClass(type) ? Arrays.stream(type.getInterfaces()) : Stream.of(type);
    String codebase =
        named
            .map(each -> kinds.get(each.getName()))
            .filter(Objects::nonNull)
            .findFirst()
            .orElseGet(() -> System.getProperty(CODEBASE));
    return codebase == null || codebase.isBlank() ? null : codebase;
  }

  /**
   * The options with which another virtual machine of DFRA gets the same: a child inherits none.
   * Its codebase is not among them, since that is the affair of who serves.
   */
  public static List<String> options() {
    List<String> options = new ArrayList<>();
    options.add("-D" + PROVIDER + "=" + VerifiedClassProvider.class.getName());
    options.add("-D" + CODEBASE_ONLY + "=false");
    String trust = System.getProperty(CodeTrust.PROPERTY);
    if (trust != null && !trust.isBlank()) {
      options.add("-D" + CodeTrust.PROPERTY + "=" + Path.of(trust).toAbsolutePath());
    }
    return options;
  }

  /** The provider that the JDK made says so. */
  static void markInstalled() {
    inPlace = true;
  }

  /** What is trusted, read from the configuration where no main has installed it. */
  static synchronized VerifiedLoaderCache loaders() throws IOException {
    if (loaders == null) {
      loaders =
          new VerifiedLoaderCache(new CodebaseVerifier(CodeTrust.configured()), System::nanoTime);
    }
    return loaders;
  }
}
