package org.dfra.core.state;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.dfra.core.state.StateStore.Counters;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FolderStateStoreTest {

  @TempDir Path folder;

  @Test
  void writesDocumentsWholeAndLeavesNothingBeside() throws Exception {
    StateStore state = StateStore.inFolder(folder.resolve("robot/module"));
    assertThat(state.read("history")).isEmpty();
    state.write("history", bytes("one"));
    state.write("history", bytes("two"));
    assertThat(state.read("history")).hasValue(bytes("two"));
    try (Stream<Path> files = Files.list(folder.resolve("robot/module"))) {
      assertThat(files.map(file -> file.getFileName().toString())).containsExactly("history");
    }
  }

  @Test
  void countersSurviveAKilledProcess() throws Exception {
    Process child =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                CountAndDie.class.getName(),
                folder.toString())
            .inheritIO()
            .start();
    assertThat(child.waitFor(30, TimeUnit.SECONDS)).isTrue();
    assertThat(child.exitValue()).as("killed, not ended").isNotZero();
    Counters counters = StateStore.inFolder(folder).counters("events", 2);
    assertThat(List.of(counters.get(0), counters.get(1))).containsExactly(1_000_000L, -7L);
  }

  /** On a full disk a mapped file's page that is not there yet is an error of the JVM's own. */
  @Test
  void countersOnAFullDiskAreRefusedAndNoError() throws Exception {
    Path disk = Files.createDirectory(folder.resolve("disk"));
    assumeThat(run("mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", disk.toString()))
        .as("mounting a small tmpfs needs root")
        .isZero();
    try {
      StateStore state = StateStore.inFolder(Files.createDirectory(disk.resolve("module")));
      fill(disk.resolve("rest"));
      assertThatIOException()
          .isThrownBy(() -> state.counters("events", 2))
          .withMessageContaining("No space left on device");
      Files.delete(disk.resolve("rest"));
      Counters counters = state.counters("events", 2);
      fill(disk.resolve("rest"));
      counters.set(1, 7);
      counters.force();
      assertThat(StateStore.inFolder(disk.resolve("module")).counters("events", 2).get(1))
          .isEqualTo(7);
    } finally {
      run("umount", "-l", disk.toString());
    }
  }

  private static void fill(Path file) throws IOException {
    try (OutputStream out = Files.newOutputStream(file)) {
      while (true) {
        out.write(new byte[512]);
      }
    } catch (IOException e) {
      assertThat(e).hasMessageContaining("No space");
    }
  }

  private static int run(String... command) throws Exception {
    try {
      return new ProcessBuilder(command)
          .redirectErrorStream(true)
          .redirectOutput(ProcessBuilder.Redirect.DISCARD)
          .start()
          .waitFor();
    } catch (IOException e) {
      return -1; // no such command
    }
  }

  /** Counts and is dead in the next moment, without any chance to tidy up. */
  static final class CountAndDie {
    public static void main(String[] args) throws IOException {
      Counters counters = StateStore.inFolder(Path.of(args[0])).counters("events", 2);
      counters.set(1, -7);
      for (long i = 1; i <= 1_000_000; i++) {
        counters.set(0, i);
      }
      Runtime.getRuntime().halt(9);
    }
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }
}
