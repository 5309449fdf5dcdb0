package org.dfra.attack.local;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.junit.jupiter.api.Assumptions.abort;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import org.dfra.benchmarks.attack.OtherUser;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.core.host.FreePorts;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.robot.RunningPhoenix;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A lock that a user without rights took while a former version left it open. */
class StolenLockIT {

  private static final Duration PATIENCE = Duration.ofSeconds(60);

  @TempDir Path temp;

  @Test
  void folderIsRefusedWhileOthersMayEnterItAndThenTheThiefIsNamed() throws Exception {
    assumeTrue(Files.isReadable(Path.of("/proc/locks")), "only Linux tells who holds a lock");
    OtherUser nobody =
        OtherUser.find(Files.createDirectory(temp.resolve("classes")))
            .orElseGet(() -> abort("needs " + OtherUser.NEEDS));
    Path state = Files.createDirectory(temp.resolve("state"));
    Path journal = Files.createDirectory(state.resolve("journal"));
    Path lock = Files.writeString(journal.resolve("phoenix.lock"), "1");
    set(state, "rwxr-xr-x");
    set(journal, "rwxr-xr-x");
    set(lock, "rw-r--r--");
    PhoenixProcess phoenix = new PhoenixProcess("127.0.0.1", FreePorts.allocate(), -1, state);
    try (TaskProcess thief = nobody.start(TakeLocks.class, lock.toString())) {
      thief.awaitLine("holds " + lock, PATIENCE);
      assertThatExceptionOfType(IOException.class)
          .isThrownBy(() -> phoenix.start(PATIENCE))
          .withMessageContaining("other users may enter the folder " + state)
          .withMessageContaining("type: chmod 700 " + state);

      set(state, "rwx------");
      assertThatExceptionOfType(IOException.class)
          .isThrownBy(() -> phoenix.start(PATIENCE))
          .withMessageContaining("phoenix ended at once (exit code 1)")
          .withMessageContaining(
              "process %d of user %s still owns this journal (it holds %s)",
              thief.pid(), OtherUser.NAME, lock);
    }
    try (RunningPhoenix restarted = RunningPhoenix.start(state)) {
      assertThat(restarted.process().admin().groupStatus()).isEmpty();
      assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(lock)))
          .isEqualTo("rw-------");
    }
  }

  private static void set(Path path, String mode) throws IOException {
    Files.setPosixFilePermissions(path, PosixFilePermissions.fromString(mode));
  }
}
