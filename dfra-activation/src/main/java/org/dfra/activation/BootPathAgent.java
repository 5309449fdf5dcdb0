package org.dfra.activation;

import java.io.File;
import java.io.IOException;
import java.lang.instrument.Instrumentation;
import java.net.URISyntaxException;
import java.security.CodeSource;
import java.util.jar.JarFile;
import org.jspecify.annotations.Nullable;

/**
 * Appends the jar it comes from to the boot class path, so that any River service runs on JDK 17
 * and later without {@code -Xbootclasspath/a:}.
 *
 * <ul>
 *   <li>{@code java -javaagent:dfra-activation.jar -jar service.jar}
 *   <li>in an executable jar: {@code Launcher-Agent-Class: org.dfra.activation.BootPathAgent} and
 *       {@code Class-Path: dfra-activation.jar}, then {@code java -jar} alone
 * </ul>
 *
 * <p>It runs before the main class is loaded. If the boot loader has the package already, it does
 * nothing. If it fails, the JVM does not start, and an error message gives the reason.
 */
public final class BootPathAgent {

  /**
   * The first class that JERI needs; present only where this module or a JDK before 17 provides it.
   */
  private static final String WANTED = "java.rmi.activation.ActivationID";

  private BootPathAgent() {}

  /**
   * Called by the JVM for {@code -javaagent}.
   *
   * @param options ignored
   * @param instrumentation the JVM's
   * @throws IllegalStateException if the boot loader does not find the package afterwards
   */
  public static void premain(@Nullable String options, Instrumentation instrumentation) {
    install(instrumentation);
  }

  /**
   * Called by the JVM for {@code Launcher-Agent-Class}, or on attaching to a running JVM.
   *
   * @param options ignored
   * @param instrumentation the JVM's
   * @throws IllegalStateException if the boot loader does not find the package afterwards
   */
  public static void agentmain(@Nullable String options, Instrumentation instrumentation) {
    install(instrumentation);
  }

  private static void install(Instrumentation instrumentation) {
    if (onBootClassPath()) {
      return;
    }
    File jar = ownJar();
    try (JarFile opened = new JarFile(jar)) {
      instrumentation.appendToBootstrapClassLoaderSearch(opened);
    } catch (IOException e) {
      throw refusal(jar + " cannot be opened as a jar (" + e.getMessage() + ")");
    }
    if (!onBootClassPath()) {
      throw refusal(jar + " does not contain " + WANTED);
    }
  }

  private static boolean onBootClassPath() {
    try {
      return Class.forName(WANTED, true, null).getClassLoader() == null;
    } catch (ClassNotFoundException e) {
      return false;
    }
  }

  private static File ownJar() {
    CodeSource source = BootPathAgent.class.getProtectionDomain().getCodeSource();
    if (source == null || source.getLocation() == null) {
      throw refusal("this agent does not know which jar it comes from");
    }
    try {
      return new File(source.getLocation().toURI());
    } catch (URISyntaxException | IllegalArgumentException e) {
      throw refusal(source.getLocation() + " is not a file");
    }
  }

  private static IllegalStateException refusal(String reason) {
    return new IllegalStateException(
        "java.rmi.activation cannot be added to the boot class path, since "
            + reason
            + ": start this JVM with -Xbootclasspath/a:dfra-activation.jar instead.");
  }
}
