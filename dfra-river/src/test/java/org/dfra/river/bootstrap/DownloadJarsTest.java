package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DownloadJarsTest {

  @TempDir private Path lib;

  @Test
  void areThoseInTheFolderOfTheDistribution() throws IOException {
    Path dl = Files.createDirectory(lib.resolve("dl"));
    Path b = Files.createFile(dl.resolve("b.jar"));
    Path a = Files.createFile(dl.resolve("a.jar"));
    Files.createFile(dl.resolve("readme.txt"));
    assertThat(DownloadJars.listJars(lib.toString())).containsExactly(a, b);
    assertThat(DownloadJars.listJars(null)).as("a part of another program").isEmpty();
  }

  @Test
  void areMissedByName() {
    assertThatThrownBy(() -> DownloadJars.listJars(lib.toString()))
        .isInstanceOf(IOException.class)
        .hasMessage(
            "there is no jar for clients to download in "
                + lib.resolve("dl")
                + "; rebuild DFRA, or write class-server-port=\"off\" in <registrar>");
  }
}
