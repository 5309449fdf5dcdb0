package org.dfra.river.loading;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.server.RMIClassLoader;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Switches downloaded code on in this virtual machine, for code that is trusted.
 *
 * <p>A main calls {@link #install()} before it uses RMI or River, and gives {@link #options()} to
 * the virtual machines it starts. {@link #annotate} says where those that lack its classes find
 * them.
 */
public final class TrustedCode {

  private static final String PROVIDER = "java.rmi.server.RMIClassLoaderSpi";
  private static final String CODEBASE_ONLY = "java.rmi.server.useCodebaseOnly";
  private static final String CODEBASE = "java.rmi.server.codebase";

  private static volatile boolean inPlace;
  private static @Nullable Loaders loaders; // guarded by the class

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
    if (inPlace && loaders != null) {
      return;
    }
    System.setProperty(PROVIDER, VerifiedClassProvider.class.getName());
    // Codebases in streams count: it is the provider that decides which.
    System.setProperty(CODEBASE_ONLY, "false");
    loaders = new Loaders(new Admission(trust), System::nanoTime);
    RMIClassLoader.getClassAnnotation(TrustedCode.class); // has the JDK make the provider now
    if (!inPlace) {
      throw new IllegalStateException(
          "RMI has another class provider already; call TrustedCode.install() first in main, or"
              + " start with -D"
              + PROVIDER
              + "="
              + VerifiedClassProvider.class.getName());
    }
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
  static void inPlace() {
    inPlace = true;
  }

  /** What is trusted, read from the configuration where no main has installed it. */
  static synchronized Loaders loaders() throws IOException {
    if (loaders == null) {
      loaders = new Loaders(new Admission(CodeTrust.configured()), System::nanoTime);
    }
    return loaders;
  }
}
