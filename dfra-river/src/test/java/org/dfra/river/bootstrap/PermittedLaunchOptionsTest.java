package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What phoenix is permitted to start groups with. */
class PermittedLaunchOptionsTest {

  @TempDir Path state;

  @Test
  void eachIsWrittenOnceInAPrivateFile() throws Exception {
    Path file = PermittedLaunchOptions.files(state).get(0);
    PermittedLaunchOptions.permit(state, List.of("-Xshare:auto", "-cp", "/a.jar:/b.jar"));
    PermittedLaunchOptions.permit(state, List.of("-Xshare:auto", "-cp", "/c.jar"));
    PermittedLaunchOptions.permit(state, List.of("-cp", "/a.jar:/b.jar", "-Xshare:auto"));
    assertThat(Files.readAllLines(file))
        .containsExactly("-Xshare:auto", "-cp /a.jar:/b.jar", "-cp /c.jar");
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
        .isEqualTo("rw-------");
    PermittedLaunchOptions.clear(state);
    assertThat(file).doesNotExist();
    PermittedLaunchOptions.clear(state);
  }

  @Test
  void usersFileIsLeftAlone() throws Exception {
    Path users = PermittedLaunchOptions.files(state).get(1);
    Files.writeString(users, "-Dmine=1\n");
    PermittedLaunchOptions.clear(state);
    PermittedLaunchOptions.permit(state, List.of("-Xint"));
    assertThat(users).hasContent("-Dmine=1\n");
  }
}
