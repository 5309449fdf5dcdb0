package org.dfra.cli.doctor;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.dfra.cli.doctor.CheckRunner.Check;

/**
 * Checks which Java runs DFRA.
 *
 * @param feature its feature number, such as 17
 * @param version its version string
 * @param home its folder
 * @param modules its Java modules
 */
record JavaCheck(int feature, String version, String home, Set<String> modules) implements Check {

  private static final int LEAST = 17;

  /** Modules that a runtime made by jlink may lack. */
  private static final Set<String> NEEDED =
      Set.of(
          "java.logging",
          "java.management",
          "java.naming",
          "java.rmi",
          "java.xml",
          "jdk.unsupported");

  JavaCheck {
    modules = Set.copyOf(modules);
  }

  /** The Java that runs this process. */
  static JavaCheck ofThisProcess() {
    return new JavaCheck(
        Runtime.version().feature(),
        System.getProperty("java.version"),
        System.getProperty("java.home"),
        ModuleLayer.boot().modules().stream().map(Module::getName).collect(Collectors.toSet()));
  }

  @Override
  public Subject subject() {
    return Subject.JAVA;
  }

  @Override
  public List<Finding> run() {
    String what = "Java " + version + " at " + home;
    if (feature < LEAST) {
      return List.of(
          Finding.fail(
              subject(),
              what + " is older than " + LEAST,
              "Install Java " + LEAST + " or newer, and name its folder in JAVA_HOME."));
    }
    Set<String> missing = new TreeSet<>(NEEDED);
    missing.removeAll(modules);
    return List.of(
        missing.isEmpty()
            ? Finding.ok(subject(), what)
            : Finding.fail(
                subject(),
                what + " lacks " + String.join(", ", missing),
                "Install a whole Java runtime, or make one with jlink that has these modules."));
  }
}
