package org.dfra.river.phoenix;

import java.util.ArrayList;
import java.util.List;
import org.dfra.river.access.AdministrationPolicy;
import org.dfra.river.security.SecureProcess;

/**
 * The options and properties that a group may be started with by default: options that limit and
 * tune a virtual machine, and properties that configure DFRA in it. None of them names a file, a
 * class, a command or a port.
 *
 * <p>In each text {@code *} matches any characters.
 */
final class StandardExecPermissions {

  /** Permitted options of the virtual machine. */
  static final List<String> OPTIONS =
      List.of(
          "-Xmx*",
          "-Xms*",
          "-Xmn*",
          "-Xss*",
          "-Xint",
          "-Xrs",
          "-Xshare:auto",
          "-Xshare:off",
          "-Xlog:gc",
          "-verbose:gc",
          "-server",
          "-ea*",
          "-da*",
          "-esa",
          "-dsa",
          "-XX:+UseSerialGC",
          "-XX:+UseParallelGC",
          "-XX:+UseG1GC",
          "-XX:+UseZGC",
          "-XX:+UseShenandoahGC",
          "-XX:MaxGCPauseMillis=*",
          "-XX:ParallelGCThreads=*",
          "-XX:ConcGCThreads=*",
          "-XX:MaxRAMPercentage=*",
          "-XX:InitialRAMPercentage=*",
          "-XX:MaxMetaspaceSize=*",
          "-XX:MaxDirectMemorySize=*",
          "-XX:ReservedCodeCacheSize=*",
          "-XX:ActiveProcessorCount=*",
          "-XX:TieredStopAtLevel=*",
          "-XX:CompileThresholdScaling=*",
          "-XX:NativeMemoryTracking=*",
          "-XX:+ExitOnOutOfMemoryError",
          "-XX:+AlwaysPreTouch",
          "-XX:+UseStringDeduplication",
          "-XX:-OmitStackTraceInFastThrow");

  /** Permitted system properties, each as {@code name=value}. */
  static final List<String> PROPERTIES =
      List.of(
          Phoenix.GROUP_NAME + "=*",
          AdministrationPolicy.PROPERTY + "=*",
          SecureProcess.PROPERTY + "=*",
          "dfra.class-server=*",
          "dfra.class-server.*=*",
          "dfra.classes=*", // the former names of these two, in recorded groups
          "dfra.classes.*=*",
          "dfra.serial.*=*",
          "dfra.time=*",
          "java.awt.headless=*",
          "java.net.preferIPv4Stack=*",
          "java.net.preferIPv6Addresses=*",
          "file.encoding=*",
          "user.country=*",
          "user.language=*",
          "user.timezone=*");

  private StandardExecPermissions() {}

  /** The standard options and further ones, for {@code permittedOptions} in a configuration. */
  static String[] options(String[] further) {
    return with(OPTIONS, further);
  }

  /** The standard properties and further ones, for {@code permittedProperties}. */
  static String[] properties(String[] further) {
    return with(PROPERTIES, further);
  }

  private static String[] with(List<String> standard, String[] further) {
    List<String> all = new ArrayList<>(standard);
    all.addAll(List.of(further));
    return all.toArray(String[]::new);
  }
}
