package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BuildCopyUsageTest {

  @TempDir Path folder;

  private List<String> notes(Path copy) throws IOException {
    try (Stream<Path> files = Files.list(copy.resolve("states"))) {
      return files.map(BuildCopyUsageTest::read).sorted().toList();
    }
  }

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void notesEveryPhoenixThatMayStartTheseJarsOnce() throws IOException {
    Path lib = Files.createDirectories(folder.resolve("copy/lib"));
    Files.createDirectory(folder.resolve("copy/states"));
    Path first = folder.resolve("first");
    Path second = folder.resolve("second");
    for (Path each : List.of(first, second, first)) {
      BuildCopyUsage.recordUse(each, lib);
    }
    assertThat(notes(folder.resolve("copy"))).containsExactly(first + "\n", second + "\n");
  }

  @Test
  void writesNothingWhereDfraIsInstalled() throws IOException {
    Path lib = Files.createDirectories(folder.resolve("dfra-1.0/lib"));
    BuildCopyUsage.recordUse(folder.resolve("state"), lib);
    try (Stream<Path> files = Files.walk(folder)) {
      assertThat(files).containsExactlyInAnyOrder(folder, lib.getParent(), lib);
    }
  }
}
