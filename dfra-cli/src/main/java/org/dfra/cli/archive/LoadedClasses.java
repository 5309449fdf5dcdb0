package org.dfra.cli.archive;

import java.io.File;
import java.io.IOException;
import java.io.Serializable;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.activation.ActivationID;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import org.jspecify.annotations.Nullable;

/**
 * An object whose constructor loads all classes of some jars, for the archive that its process will
 * write.
 */
final class LoadedClasses implements Remote, Serializable {

  private static final long serialVersionUID = 1L;

  private static final String CLASS = ".class";

  /** What processes of robots have classes of. */
  private static final List<String> ROBOT_JARS =
      List.of(
          "dfra-api",
          "dfra-core",
          "dfra-client",
          "dfra-phoenix",
          "dfra-river",
          "dfra-drivers",
          "dfra-behaviors",
          "dfra-recruit",
          "jsk-");

  /** Called by the activation system. */
  LoadedClasses(ActivationID id, @Nullable MarshalledObject<?> none) throws IOException {
    ProcessHandle.current() // a group outlives its phoenix, but this one is of no use then
        .parent()
        .ifPresent(
            starter -> {
              var unused = starter.onExit().thenRun(() -> Runtime.getRuntime().halt(1));
            });
    load(ROBOT_JARS);
  }

  /**
   * Loads the classes of jars of the class path, and initializes none.
   *
   * @param jars the beginnings of the jars' names
   * @throws IOException if a jar cannot be read
   */
  static void load(List<String> jars) throws IOException {
    for (String each : System.getProperty("java.class.path").split(File.pathSeparator, -1)) {
      Path jar = Path.of(each);
      String name = String.valueOf(jar.getFileName());
      if (jars.stream().anyMatch(name::startsWith) && Files.isRegularFile(jar)) {
        load(jar);
      }
    }
  }

  private static void load(Path jar) throws IOException {
    try (JarFile file = new JarFile(jar.toFile())) {
      file.stream()
          .map(JarEntry::getName)
          .filter(name -> name.endsWith(CLASS) && !name.startsWith("META-INF/"))
          .forEach(name -> load(name.substring(0, name.length() - CLASS.length())));
    }
  }

  private static void load(String name) {
    try {
      Class<?> unused =
          Class.forName(name.replace('/', '.'), false, LoadedClasses.class.getClassLoader());
    } catch (ClassNotFoundException | LinkageError e) {
      // It needs a library that is not here, such as one for tests: no process uses it.
    }
  }
}
