package org.dfra.activation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** A JVM of the same JDK, run to its end: its exit code and what it printed, both streams. */
record ChildJvm(int exit, String printed) {

  private static final long DEADLINE_S = 60;

  static ChildJvm run(Path folder, List<String> arguments)
      throws IOException, InterruptedException {
    Path output = Files.createTempFile(folder, "child", ".out");
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(arguments);
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    // Options from outside would reach the child but not the claim under test.
    builder.environment().remove("JAVA_TOOL_OPTIONS");
    builder.environment().remove("JDK_JAVA_OPTIONS");
    Process process = builder.redirectOutput(output.toFile()).start();
    try {
      if (!process.waitFor(DEADLINE_S, TimeUnit.SECONDS)) {
        throw new AssertionError(
            "Still running after " + DEADLINE_S + " s: " + Files.readString(output));
      }
      return new ChildJvm(process.exitValue(), Files.readString(output));
    } finally {
      process.destroyForcibly().waitFor();
    }
  }
}
