package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.rmi.ConnectException;
import java.time.Duration;
import org.dfra.core.host.FreePorts;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The folder of what phoenix keeps, before phoenix starts with it. */
class StateFolderTest {

  @TempDir Path temp;

  @Test
  void openFolderIsRefusedBeforeAnythingIsStarted() throws Exception {
    Path state = Files.createDirectory(temp.resolve("state"));
    Files.setPosixFilePermissions(state, PosixFilePermissions.fromString("rwxr-x---"));
    assertThatExceptionOfType(IOException.class)
        .isThrownBy(() -> phoenix(state).start(Duration.ofSeconds(30)))
        .withMessage(
            "other users may enter the folder %s (rwxr-x---), which must be private; type: chmod"
                + " 700 %s",
            state, state);
    assertThat(state).isEmptyDirectory();
  }

  @Test
  void withoutAnIdentityNobodyAnswers() throws Exception {
    PhoenixProcess phoenix = phoenix(temp.resolve("none"));
    assertThat(phoenix.isResponding()).isFalse();
    assertThatExceptionOfType(ConnectException.class).isThrownBy(phoenix::admin);
    phoenix.requireOwnedByUser();
    assertThat(temp).isEmptyDirectory();
  }

  private static PhoenixProcess phoenix(Path state) throws IOException {
    return new PhoenixProcess("127.0.0.1", FreePorts.allocate(), -1, state);
  }
}
