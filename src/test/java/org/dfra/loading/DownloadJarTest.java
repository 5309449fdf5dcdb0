package org.dfra.loading;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.jar.JarFile;
import java.util.stream.Stream;
import org.dfra.river.proxy.ModuleProxy;
import org.junit.jupiter.api.Test;

/** What a client without dfra-river downloads is enough for it. */
class DownloadJarTest {

  private static final Path ROOT = Path.of(System.getProperty("dfra.root"), "dfra-river");

  @Test
  void needsTheApiTheCoreRiverAndItsLoggingApiOnly() throws Exception {
    try (JarFile jar = new JarFile(file().toFile())) {
      JavaClasses classes = new ClassFileImporter().importJar(jar);
      assertThat(classes.contain(ModuleProxy.class)).isTrue();
      assertThat(classes.contain("org.dfra.river.server.ModuleServer")).isFalse();
      Set<String> missing = new TreeSet<>();
      for (JavaClass each : classes) {
        each.getDirectDependenciesFromSelf().stream()
            .map(dependency -> dependency.getTargetClass().getBaseComponentType())
            .filter(target -> !target.isPrimitive() && !isKnown(target.getName()))
            .filter(target -> !classes.contain(target.getName()))
            .forEach(target -> missing.add(each.getName() + " needs " + target.getName()));
      }
      assertThat(missing).isEmpty();
    }
  }

  /** What a stranger has, or gets from dfra-api.jar and dfra-core.jar in the same codebase. */
  private static boolean isKnown(String name) {
    return Stream.of(
                "java.",
                "javax.",
                "net.jini.",
                "com.sun.jini.",
                "org.jspecify.",
                "org.slf4j.",
                "org.dfra.")
            .anyMatch(name::startsWith)
        && !name.startsWith("org.dfra.river.");
  }

  static Path file() {
    return Stream.of("target/dfra-river-dl.jar", "build/libs/dfra-river-dl.jar")
        .map(ROOT::resolve)
        .filter(Files::exists)
        .findFirst()
        .orElseThrow(() -> new AssertionError("no dfra-river-dl.jar in " + ROOT + "; build it"));
  }
}
