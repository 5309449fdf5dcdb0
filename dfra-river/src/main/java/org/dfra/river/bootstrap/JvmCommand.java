package org.dfra.river.bootstrap;

import java.io.File;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dfra.core.config.RenamedNames;
import org.dfra.core.host.CommandName;
import org.dfra.core.time.RobotTime;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.phoenix.host.ClassArchive;
import org.jspecify.annotations.Nullable;

/**
 * Builds the command that starts another virtual machine of DFRA from this one: the same java, the
 * same boot class path and class path. A child inherits no options by itself.
 */
public final class JvmCommand {

  /** System property with the value of {@code -Xbootclasspath/a}, if the launcher knows it. */
  static final String BOOT = "dfra.boot-class-path";

  private JvmCommand() {}

  /** The java command of this virtual machine. */
  public static String java() {
    return Path.of(System.getProperty("java.home"), "bin", "java").toString();
  }

  /**
   * The options that a virtual machine of DFRA needs: paths, trust, time, the name of the command,
   * fast start. Among them are those that only this Java understands.
   */
  public static List<String> options() {
    List<String> options = lastingOptions();
    List<String> all = new ArrayList<>(ClassArchive.startOptions(options));
    @Nullable String archive = System.getProperty(ClassArchive.COMMANDS);
    if (archive != null && !archive.isBlank()) {
      all.add("-D" + ClassArchive.COMMANDS + "=" + absolute(archive));
    }
    all.addAll(options);
    return all;
  }

  /**
   * The archive of classes for virtual machines with these options, whether it exists or not; empty
   * if the command that started this one keeps no archives.
   */
  public static Optional<ClassArchive> archive() {
    return ClassArchive.of(lastingOptions());
  }

  /**
   * The same, without options of this Java: phoenix stores those of groups, and adds to them what
   * its own Java understands.
   */
  static List<String> lastingOptions() {
    List<String> options = new ArrayList<>(bootOptions());
    options.addAll(TrustedCode.options());
    options.addAll(SerialFilters.options());
    options.addAll(RobotTime.options());
    options.addAll(CommandName.options());
    options.add("-XX:TieredStopAtLevel=1");
    options.add("-XX:CompileThresholdScaling=3"); // compilation took a third of the start time
    options.add("-XX:+UseSerialGC");
    options.add("-cp");
    options.add(classPath());
    return options;
  }

  private static List<String> bootOptions() {
    String boot = RenamedNames.property(System.getProperties(), BOOT);
    if (boot != null) {
      return List.of("-Xbootclasspath/a:" + absolute(boot), "-D" + BOOT + "=" + absolute(boot));
    }
    return ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
        .filter(o -> o.startsWith("-Xbootclasspath/a:") || o.startsWith("-javaagent:"))
        .map(o -> o.substring(0, o.indexOf(':') + 1) + absolute(o.substring(o.indexOf(':') + 1)))
        .toList();
  }

  private static String classPath() {
    return absolute(System.getProperty("java.class.path"));
  }

  private static String absolute(String path) {
    return Stream.of(path.split(File.pathSeparator, -1))
        .filter(entry -> !entry.isEmpty())
        .map(entry -> Path.of(entry).toAbsolutePath().toString())
        .collect(Collectors.joining(File.pathSeparator));
  }
}
