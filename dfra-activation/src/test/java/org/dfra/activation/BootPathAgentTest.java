package org.dfra.activation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A River service starts with the jar put on the boot class path, in any of three ways. */
class BootPathAgentTest {

  private static final String MAIN = JeriExportMain.class.getName();
  private static final String SUCCESS = JeriExportMain.DONE + "null";

  @TempDir private Path folder;
  private Path jar;

  @BeforeEach
  void packTheModuleAsTheBuildDoes() throws IOException {
    jar = pack("dfra-activation.jar", manifest(), name -> true);
  }

  /** Read where both builds read it. */
  private static Manifest manifest() throws IOException {
    Path file =
        Path.of(System.getProperty("dfra.root"), "dfra-activation/src/main/manifest/MANIFEST.MF");
    try (InputStream in = Files.newInputStream(file)) {
      return new Manifest(in);
    }
  }

  private Path pack(String name, Manifest manifest, Predicate<String> wanted) throws IOException {
    Path classes = Path.of(System.getProperty("dfra.boot-class-path"));
    Path packed = folder.resolve(name);
    try (OutputStream file = Files.newOutputStream(packed);
        JarOutputStream out = new JarOutputStream(file, manifest);
        Stream<Path> files = Files.walk(classes)) {
      for (Path source : files.filter(Files::isRegularFile).toList()) {
        String entry = classes.relativize(source).toString().replace(File.separatorChar, '/');
        if (wanted.test(entry) && entry.endsWith(".class")) {
          out.putNextEntry(new JarEntry(entry));
          Files.copy(source, out);
          out.closeEntry();
        }
      }
    }
    return packed;
  }

  /** The tests' class path without this module: the child must get it from the jar. */
  private static String classPath() {
    Path own = Path.of(System.getProperty("dfra.boot-class-path"));
    String[] entries = System.getProperty("java.class.path").split(File.pathSeparator);
    return String.join(
        File.pathSeparator,
        Arrays.stream(entries).filter(entry -> !Path.of(entry).equals(own)).toList());
  }

  @Test
  void jeriDoesNotStartWithoutIt() throws Exception {
    ChildJvm child = ChildJvm.run(folder, List.of("-cp", classPath(), MAIN));

    assertThat(child.exit()).isNotZero();
    assertThat(child.printed()).contains("NoClassDefFoundError: java/rmi/activation/ActivationID");
  }

  @Test
  void jeriStartsWithTheAgent() throws Exception {
    ChildJvm child = ChildJvm.run(folder, List.of("-javaagent:" + jar, "-cp", classPath(), MAIN));

    assertThat(child.printed()).contains(SUCCESS);
    assertThat(child.exit()).isZero();
  }

  @Test
  void jeriStartsWithTheBootClassPathOption() throws Exception {
    ChildJvm child =
        ChildJvm.run(folder, List.of("-Xbootclasspath/a:" + jar, "-cp", classPath(), MAIN));

    assertThat(child.printed()).contains(SUCCESS);
    assertThat(child.exit()).isZero();
  }

  @Test
  void agentAndBootClassPathOptionTogetherDoNoHarm() throws Exception {
    ChildJvm child =
        ChildJvm.run(
            folder,
            List.of("-Xbootclasspath/a:" + jar, "-javaagent:" + jar, "-cp", classPath(), MAIN));

    assertThat(child.printed()).contains(SUCCESS);
    assertThat(child.exit()).isZero();
  }

  @Test
  void executableJarNamesTheLauncherAgentAndNeedsNoFlag() throws Exception {
    Manifest manifest = new Manifest();
    Attributes attributes = manifest.getMainAttributes();
    attributes.put(Attributes.Name.MANIFEST_VERSION, "1.0");
    attributes.put(Attributes.Name.MAIN_CLASS, MAIN);
    attributes.putValue("Launcher-Agent-Class", BootPathAgent.class.getName());
    attributes.put(
        Attributes.Name.CLASS_PATH,
        jar.toUri()
            + " "
            + String.join(
                " ",
                Arrays.stream(classPath().split(File.pathSeparator))
                    .map(entry -> Path.of(entry).toUri().toString())
                    .toList()));
    Path service = pack("service.jar", manifest, name -> false);

    ChildJvm child = ChildJvm.run(folder, List.of("-jar", service.toString()));

    assertThat(child.printed()).contains(SUCCESS).doesNotContain("WARNING");
    assertThat(child.exit()).isZero();
  }

  @Test
  void jarWithoutThePackageIsRefusedInOneSentence() throws Exception {
    Path broken = pack("broken.jar", manifest(), name -> name.startsWith("org/"));

    ChildJvm child =
        ChildJvm.run(folder, List.of("-javaagent:" + broken, "-cp", classPath(), MAIN));

    assertThat(child.exit()).isNotZero();
    assertThat(child.printed())
        .contains(
            "java.rmi.activation cannot be added to the boot class path, since "
                + broken
                + " does not contain java.rmi.activation.ActivationID: start this JVM with"
                + " -Xbootclasspath/a:dfra-activation.jar instead.")
        .doesNotContain(SUCCESS);
  }

  @Test
  void classesInAFolderAreRefusedInOneSentence() throws Exception {
    String classes = System.getProperty("dfra.boot-class-path");

    ChildJvm child =
        ChildJvm.run(
            folder,
            List.of("-javaagent:" + jar, "-cp", classes + File.pathSeparator + classPath(), MAIN));

    assertThat(child.exit()).isNotZero();
    assertThat(child.printed())
        .contains("since " + classes + " cannot be opened as a jar (")
        .contains("-Xbootclasspath/a:dfra-activation.jar instead.");
  }
}
