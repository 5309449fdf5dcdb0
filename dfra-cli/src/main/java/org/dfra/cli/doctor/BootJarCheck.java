package org.dfra.cli.doctor;

import java.util.List;
import java.util.Optional;
import org.dfra.cli.doctor.CheckRunner.Check;
import org.dfra.core.config.RenamedNames;
import org.jspecify.annotations.Nullable;

/** Checks that only the boot loader defines {@code java.rmi.activation}. */
final class BootJarCheck implements Check {

  private static final String PROBE = "java.rmi.activation.ActivationID";
  private static final String REMEDY =
      "Start it by the script dfra, or give the JVM -Xbootclasspath/a: with dfra-activation.jar.";

  /** Finds a class by its name. */
  interface ClassFinder {
    Class<?> named(String name) throws ClassNotFoundException;
  }

  private final ClassFinder classes;
  private final Optional<String> jar;

  /**
   * @param classes looks up the class
   * @param jar the jar that the launcher has put on the boot class path, if known
   */
  BootJarCheck(ClassFinder classes, Optional<String> jar) {
    this.classes = classes;
    this.jar = jar;
  }

  /** The check for this process. */
  static BootJarCheck ofThisProcess() {
    return new BootJarCheck(
        Class::forName,
        Optional.ofNullable(RenamedNames.property(System.getProperties(), "dfra.boot-class-path")));
  }

  @Override
  public Subject subject() {
    return Subject.BOOT_JAR;
  }

  @Override
  public List<Finding> run() {
    try {
      @Nullable ClassLoader loader = classes.named(PROBE).getClassLoader();
      return List.of(
          loader == null
              ? Finding.ok(
                  subject(), "java.rmi.activation comes from " + jar.orElse("the boot class path"))
              : Finding.fail(
                  subject(),
                  "java.rmi.activation is on the class path, not on the boot class path",
                  REMEDY));
    } catch (ClassNotFoundException e) {
      return List.of(Finding.fail(subject(), "there is no java.rmi.activation", REMEDY));
    }
  }
}
