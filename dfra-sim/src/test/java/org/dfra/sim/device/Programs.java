package org.dfra.sim.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Programs that a test needs and a computer may lack. */
public final class Programs {

  private Programs() {}

  /** Skips the test where the program is not installed. */
  public static void require(String program) {
    assertThat(find(program)).isNotEmpty();
  }

  /** Where the program is; skips the test where it is not installed. */
  public static String find(String program) {
    List<String> folders = new ArrayList<>();
    folders.addAll(List.of(System.getenv().getOrDefault("PATH", "").split(File.pathSeparator, -1)));
    folders.add("/usr/sbin"); // where daemons are, and not on every user's path
    for (String folder : folders) {
      Path path = Path.of(folder, program);
      if (Files.isExecutable(path)) {
        return path.toString();
      }
    }
    assumeTrue(false, program + " is not installed: this test needs the real one");
    throw new AssertionError();
  }

  /** Ends a process and waits until it has. */
  public static void end(Process process) throws InterruptedException {
    process.destroyForcibly().waitFor();
  }
}
