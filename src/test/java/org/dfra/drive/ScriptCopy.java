package org.dfra.drive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.dfra.dist.BuiltJars;

/**
 * A checkout in which nothing can be built: a copy of the script {@code ./dfra}, of the jars that
 * this build has made, where the script looks for them, and a source file that does not compile.
 */
final class ScriptCopy implements AutoCloseable {

  private static final Path ROOT = Path.of(System.getProperty("dfra.root"));

  private final Path folder;
  private final Deque<Process> started = new ArrayDeque<>();

  /**
   * @param folder a folder of this test alone, which is made
   */
  ScriptCopy(Path folder) throws IOException {
    BuiltJars built = BuiltJars.assumed();
    this.folder = folder;
    copy(ROOT.resolve("dfra"), folder.resolve("dfra"));
    copy(ROOT.resolve("src/dist/libexec/java.sh"), folder.resolve("src/dist/libexec/java.sh"));
    Path jars = folder.resolve(".dfra/jars/one");
    try (Stream<Path> files = Files.walk(built.lib())) {
      for (Path each : files.filter(Files::isRegularFile).toList()) {
        copy(each, jars.resolve("lib").resolve(built.lib().relativize(each)));
      }
    }
    copy(built.boot(), boot(jars));
    archiveClasses(jars);
    Files.writeString(jars.resolve("fingerprint"), "of other sources\n");
    Files.createSymbolicLink(jars.resolveSibling("current"), Path.of("one"));
    Path sources = Files.createDirectories(folder.resolve("dfra-cli/src/main/java"));
    Files.writeString(sources.resolve("Broken.java"), "class Broken { this does not compile }\n");
    Files.writeString(folder.resolve("pom.xml"), "<project/>\n");
  }

  private static void copy(Path from, Path to) throws IOException {
    Files.createDirectories(to.getParent());
    Files.copy(from, to, StandardCopyOption.COPY_ATTRIBUTES);
  }

  /** As {@code ./dfra build} does after it has put the jars there. */
  private void archiveClasses(Path jars) throws IOException {
    String home = "home='" + System.getProperty("java.home") + "'";
    String archive = "archive_classes '" + jars.resolve("lib") + "' '" + boot(jars) + "'";
    Path functions = folder.resolve("src/dist/libexec/java.sh");
    Process script =
        new ProcessBuilder("sh", "-euc", ". '" + functions + "'; " + home + "; " + archive)
            .redirectErrorStream(true)
            .start();
    String output = new String(script.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    try (Stream<Path> files = Files.list(jars.resolve("lib/archive"))) {
      assertThat(files.map(Path::toString)).as(output).anyMatch(each -> each.endsWith(".jsa"));
    }
  }

  private static Path boot(Path jars) {
    return jars.resolve("boot/dfra-activation.jar");
  }

  /** Holds the lock of builds and tests there, until this is closed. */
  void lock() throws IOException, InterruptedException {
    assumeTrue(new ProcessBuilder("which", "flock").start().waitFor() == 0, "no flock here");
    Path lock = Files.createDirectories(folder.resolve("target")).resolve("dfra.lock");
    Process holder =
        new ProcessBuilder("flock", lock.toString(), "sh", "-c", "echo held && read line").start();
    started.push(holder);
    assertThat(holder.inputReader().readLine()).isEqualTo("held");
  }

  /**
   * Starts {@code ./dfra} there, on the Java that runs this, without the variables that change what
   * it does. Its two outputs are one.
   */
  Process start(String... words) throws IOException {
    List<String> command = new ArrayList<>(List.of(folder.resolve("dfra").toString()));
    command.addAll(List.of(words));
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    Map<String, String> environment = builder.environment();
    environment.keySet().removeIf(name -> name.startsWith("DFRA_"));
    environment.put("JAVA_HOME", System.getProperty("java.home"));
    Process script = builder.start();
    started.push(script);
    return script;
  }

  /** Ends what still runs, the last first: a process that waits for the lock never gets it. */
  @Override
  public void close() throws IOException, InterruptedException {
    while (!started.isEmpty()) {
      Process each = started.pop();
      each.descendants().forEach(ProcessHandle::destroyForcibly);
      each.destroyForcibly();
      assertThat(each.waitFor(30, TimeUnit.SECONDS)).as("it has ended").isTrue();
    }
  }
}
