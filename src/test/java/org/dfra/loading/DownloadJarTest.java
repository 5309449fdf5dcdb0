package org.dfra.loading;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.Set;
import java.util.TreeSet;
import java.util.jar.JarFile;
import java.util.stream.Stream;
import org.dfra.event.delivery.ListenerQueue;
import org.dfra.module.Module;
import org.dfra.river.proxy.ModuleProxy;
import org.junit.jupiter.api.Test;

/** What a client that has only River downloads is enough for it. */
class DownloadJarTest {

  private static final Path ROOT = Path.of(System.getProperty("dfra.root"));

  @Test
  void needsTheJdkTheApiAndRiverOnly() throws Exception {
    JavaClasses api = api();
    assertThat(api.contain(ListenerQueue.class)).isTrue();
    try (JarFile jar = new JarFile(file().toFile())) {
      JavaClasses downloaded = new ClassFileImporter().importJar(jar);
      assertThat(downloaded.contain(ModuleProxy.class)).isTrue();
      assertThat(downloaded.contain("org.dfra.river.server.ModuleServer")).isFalse();
      Set<String> missing = new TreeSet<>();
      for (JavaClass each : downloaded) {
        each.getDirectDependenciesFromSelf().stream()
            .map(dependency -> dependency.getTargetClass().getBaseComponentType())
            .filter(target -> !target.isPrimitive() && !isForeign(target.getName()))
            .filter(target -> !downloaded.contain(target.getName()))
            .filter(target -> !api.contain(target.getName()))
            .forEach(target -> missing.add(each.getName() + " needs " + target.getName()));
      }
      assertThat(missing).isEmpty();
    }
  }

  /**
   * What a stranger has, or does not need: the JVM ignores annotations whose classes are missing.
   */
  private static boolean isForeign(String name) {
    return Stream.of(
            "java.",
            "javax.",
            "jdk.net.", // used only where the runtime has it
            "net.jini.",
            "com.sun.jini.",
            "org.jspecify.annotations.",
            "com.google.errorprone.annotations.")
        .anyMatch(name::startsWith);
  }

  static Path file() {
    return file("dfra-client");
  }

  /** The jar that this build has made of a module. */
  static Path file(String module) {
    return Stream.of("/target/", "/build/libs/")
        .map(folder -> ROOT.resolve(module + folder + module + ".jar"))
        .filter(Files::exists)
        .findFirst()
        .orElseThrow(() -> new AssertionError("no " + module + ".jar in " + ROOT + "; build it"));
  }

  /** From its jar or its folder of classes, whatever this build has. */
  private static JavaClasses api() throws IOException, URISyntaxException {
    CodeSource source = Module.class.getProtectionDomain().getCodeSource();
    Path api = Path.of(source.getLocation().toURI());
    ClassFileImporter importer = new ClassFileImporter();
    if (Files.isDirectory(api)) {
      return importer.importPath(api);
    }
    try (JarFile jar = new JarFile(api.toFile())) {
      return importer.importJar(jar);
    }
  }
}
