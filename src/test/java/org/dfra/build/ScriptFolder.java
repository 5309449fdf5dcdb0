package org.dfra.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * A folder with a copy of the script {@code ./dfra} and with build tools that only pretend: the
 * lock of this checkout may be held by the very run that a test is part of.
 */
final class ScriptFolder {

  /** Of the build tools that the script looks for. */
  private static final List<String> BUILD_TOOLS = List.of("mvn", "gradle");

  private final Path folder;
  private final Path tools;
  private String printed = "";

  /**
   * @param folder an empty folder of this test alone
   * @param buildTool the shell script that Maven and Gradle are there
   */
  ScriptFolder(Path folder, String buildTool) throws IOException {
    this.folder = folder;
    this.tools = Files.createDirectory(folder.resolve("tools"));
    Path root = Repository.root();
    Path libexec = Files.createDirectories(folder.resolve("src/dist/libexec"));
    Files.copy(root.resolve("dfra"), folder.resolve("dfra"));
    Files.copy(root.resolve("src/dist/libexec/java.sh"), libexec.resolve("java.sh"));
    for (String name : BUILD_TOOLS) {
      program(tools.resolve(name), buildTool);
    }
  }

  /** The folder in which the script finds its tools first. */
  Path tools() {
    return tools;
  }

  /** Writes a program. */
  static void program(Path file, String text) throws IOException {
    Files.writeString(file, text);
    assertThat(file.toFile().setExecutable(true)).isTrue();
  }

  /**
   * The script, ready to be started with these words. Its two outputs are one.
   *
   * @param tool the build tool that it uses: {@code maven} or {@code gradle}
   */
  ProcessBuilder script(String tool, String... words) {
    List<String> command = new ArrayList<>(List.of("sh", folder.resolve("dfra").toString()));
    command.addAll(List.of(words));
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    Map<String, String> environment = builder.environment();
    environment.merge("PATH", tools + ":", (old, first) -> first + old);
    environment.put("JAVA_HOME", System.getProperty("java.home"));
    environment.put("DFRA_BUILD", tool);
    return builder;
  }

  /** Runs the script, and returns its exit code. */
  int run(String tool, String verb, String... words) throws IOException, InterruptedException {
    List<String> all = new ArrayList<>(List.of(verb));
    all.addAll(List.of(words));
    Process script = script(tool, all.toArray(String[]::new)).start();
    script.getOutputStream().close();
    printed = new String(script.getInputStream().readAllBytes());
    return script.waitFor();
  }

  /** What the last run printed. */
  String printed() {
    return printed;
  }
}
