package org.dfra.river.phoenix.host;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.dfra.core.host.PrivateFiles;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Who is said to hold a lock. */
class LockHolderFinderTest {

  private static final String TABLE =
      """
      1: POSIX  ADVISORY  READ %d 00:00:%d 0 EOF
      1: -> POSIX  ADVISORY  WRITE 3 00:00:%d 0 EOF
      2: FLOCK  ADVISORY  WRITE 4 00:00:%d 0 EOF
      3: OFDLCK ADVISORY  WRITE -1 00:00:%d 0 EOF
      4: POSIX  ADVISORY  WRITE 5 00:00:1%d 0 EOF
      """;

  @TempDir Path temp;

  @Test
  void holderIsTheProcessThatLinuxNamesNotTheOneThatIsWritten() throws Exception {
    Path file = Files.writeString(temp.resolve("g.lock"), "1");
    long inode = ((Number) Files.getAttribute(file, "unix:ino")).longValue();
    Path proc = Files.createDirectory(temp.resolve("proc"));
    Files.createDirectory(proc.resolve("42"));
    Files.writeString(
        proc.resolve("locks"), TABLE.formatted(42L, inode, inode, inode, inode, inode));
    assertThat(new LockHolderFinder(proc).of(file))
        .isEqualTo("process 42 of user " + PrivateFiles.user().getName());
  }

  @Test
  void holderIsTheLivingProcessThatIsWrittenWhereNobodyElseIsNamed() throws Exception {
    long own = ProcessHandle.current().pid();
    Path file = Files.writeString(temp.resolve("g.lock"), Long.toString(own));
    assertThat(new LockHolderFinder(temp.resolve("no proc")).of(file)).isEqualTo("process " + own);
    Path proc = Files.createDirectory(temp.resolve("proc"));
    Files.writeString(proc.resolve("locks"), "");
    assertThat(new LockHolderFinder(proc).of(file)).isEqualTo("process " + own);
  }

  @Test
  void holderMayBeUnknown() throws Exception {
    for (String text : new String[] {"", "garbage", "99999999999999999", "12345678901234567890"}) {
      Path file = Files.writeString(temp.resolve("g.lock"), text);
      assertThat(new LockHolderFinder(temp.resolve("no proc")).of(file))
          .as("a file with \"%s\"", text)
          .isEqualTo("an unknown process");
    }
  }
}
