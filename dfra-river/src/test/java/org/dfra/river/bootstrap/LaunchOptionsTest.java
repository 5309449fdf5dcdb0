package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What phoenix is permitted to start groups with. */
class LaunchOptionsTest {

  @TempDir Path state;

  @Test
  void eachIsWrittenOnceInAPrivateFile() throws Exception {
    Path file = LaunchOptions.files(state).get(0);
    LaunchOptions.permit(state, List.of("-Xshare:auto", "-cp", "/a.jar:/b.jar"));
    LaunchOptions.permit(state, List.of("-Xshare:auto", "-cp", "/c.jar"));
    LaunchOptions.permit(state, List.of("-cp", "/a.jar:/b.jar", "-Xshare:auto"));
    assertThat(Files.readAllLines(file))
        .containsExactly("-Xshare:auto", "-cp /a.jar:/b.jar", "-cp /c.jar");
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
        .isEqualTo("rw-------");
    LaunchOptions.clear(state);
    assertThat(file).doesNotExist();
    LaunchOptions.clear(state);
  }

  @Test
  void usersFileIsLeftAlone() throws Exception {
    Path users = LaunchOptions.files(state).get(1);
    Files.writeString(users, "-Dmine=1\n");
    LaunchOptions.clear(state);
    LaunchOptions.permit(state, List.of("-Xint"));
    assertThat(users).hasContent("-Dmine=1\n");
  }
}
