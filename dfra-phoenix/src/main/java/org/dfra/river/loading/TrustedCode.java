package org.dfra.river.loading;

import com.google.errorprone.annotations.concurrent.GuardedBy;
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
 * Enables downloaded code in this virtual machine, if the code is trusted.
 *
 * <p>A main calls {@link #install()} before it uses RMI or River, and passes {@link #options()} to
 * the virtual machines it starts. {@link #annotate} sets the codebase at which other virtual
 * machines find this one's classes.
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
  private static volatile @Nullable TeamSigners team;
  private static volatile Map<String, String> kinds = Map.of();

  @GuardedBy("TrustedCode.class")
  private static @Nullable VerifiedLoaderCache loaders;

  private TrustedCode() {}

  /**
   * Makes {@link VerifiedClassProvider} RMI's class provider, with the trust of {@link
   * CodeTrust#configured()}. Does nothing the second time.
   *
   * @throws IOException if the trust file is invalid
   * @throws IllegalStateException if RMI has a class provider already
   */
  public static void install() throws IOException {
    install(CodeTrust.configured());
  }

  /**
   * As {@link #install()}, with the caller's own trust.
   *
   * @throws IllegalStateException if RMI has a class provider already
   */
  public static synchronized void install(CodeTrust trust) {
    if (!installIfAbsent(trust)) {
      throw new IllegalStateException(TAKEN);
    }
  }

  /**
   * As {@link #install()}, for a program that did not call it; a directory does this before it
   * reads its first proxy. If RMI has another class provider, logs that.
   *
   * @throws IOException if the trust file is invalid
   */
  public static void installIfAbsent() throws IOException {
    if (!inPlace && !installIfAbsent(CodeTrust.configured())) {
      LOG.warn("Proxies of robots that serve their classes cannot be read: {}.", TAKEN);
    }
  }

  /** Whether RMI's provider is now ours. */
  private static synchronized boolean installIfAbsent(CodeTrust trust) {
    if (inPlace && loaders != null) {
      return true;
    }
    System.setProperty(PROVIDER, VerifiedClassProvider.class.getName());
    // Use the codebases in streams: the provider decides which are loaded.
    System.setProperty(CODEBASE_ONLY, "false");
    loaders = new VerifiedLoaderCache(new CodebaseVerifier(trust), System::nanoTime);
    RMIClassLoader.getClassAnnotation(TrustedCode.class); // makes the JDK create the provider now
    return inPlace;
  }

  /**
   * From now on, jars are trusted too that are signed by a key of the team of this computer.
   *
   * @param signers the keys of its authority
   */
  public static void trustTeam(TeamSigners signers) {
    team = signers;
  }

  /** The keys of the team of this computer; null if it has joined none. */
  static @Nullable TeamSigners team() {
    return team;
  }

  /**
   * From now on, classes of the class path are annotated with this codebase when they leave this
   * virtual machine.
   *
   * @param codebase from {@link ClassServer#codebase}
   */
  public static void annotate(String codebase) {
    CodebaseUrl.parse(codebase);
    System.setProperty(CODEBASE, codebase);
  }

  /**
   * As {@link #annotate(String)}, with separate codebases for some classes.
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

  /** The codebase annotation of a class of the class path; null for none. */
  static @Nullable String annotation(Class<?> type) {
    // The class of a stub is created at run time; its reader may lack only its interfaces.
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
   * The options that give another virtual machine of DFRA the same settings: a child inherits none.
   * The codebase is not included; the class server sets it.
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

  /** Called by the provider when the JDK has created it. */
  static void markInstalled() {
    inPlace = true;
  }

  /** The loaders; reads the trust from the configuration if no main has installed one. */
  static synchronized VerifiedLoaderCache loaders() throws IOException {
    if (loaders == null) {
      loaders =
          new VerifiedLoaderCache(new CodebaseVerifier(CodeTrust.configured()), System::nanoTime);
    }
    return loaders;
  }
}
