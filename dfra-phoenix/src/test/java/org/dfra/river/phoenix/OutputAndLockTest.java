package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.rmi.activation.ActivationGroupDesc;
import java.util.List;
import java.util.Properties;
import java.util.UUID;
import java.util.stream.Stream;
import net.jini.config.ConfigurationFile;
import org.dfra.core.host.PrivateFiles;
import org.dfra.river.phoenix.host.ProcessLock;
import org.dfra.river.phoenix.host.RotatingFileOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The files and the command of a group's process. */
class OutputAndLockTest {

  @TempDir Path temp;

  @Test
  void fullOutputMovesOnAndOnlySoManyAreKept() throws Exception {
    Path file = temp.resolve("g.log");
    try (RotatingFileOutputStream out = new RotatingFileOutputStream(file, 10, 2)) {
      for (String line : List.of("aaaaaaa\n", "bbbbbbb\n", "ccc\n", "ddd\n", "eeeeeee\n")) {
        out.write(line.getBytes(StandardCharsets.UTF_8));
      }
    }
    assertThat(file).hasContent("eeeeeee\n");
    assertThat(temp.resolve("g.log.1")).hasContent("ccc\nddd\n");
    assertThat(temp.resolve("g.log.2")).hasContent("bbbbbbb\n");
    try (Stream<Path> files = Files.list(temp)) {
      assertThat(files).hasSize(3);
    }
  }

  @Test
  void outputOfAFormerProcessStaysAndCounts() throws Exception {
    Path file = temp.resolve("g.log");
    Files.writeString(file, "former\n");
    try (RotatingFileOutputStream out = new RotatingFileOutputStream(file, 12, 1)) {
      out.write("new\n".getBytes(StandardCharsets.UTF_8));
      assertThat(file).hasContent("former\nnew\n");
      out.write("more\n".getBytes(StandardCharsets.UTF_8));
    }
    assertThat(file).hasContent("more\n");
    assertThat(temp.resolve("g.log.1")).hasContent("former\nnew\n");
  }

  @Test
  void lineLongerThanTheLimitIsWrittenWhole() throws Exception {
    Path file = temp.resolve("g.log");
    try (RotatingFileOutputStream out = new RotatingFileOutputStream(file, 3, 1)) {
      out.write("0123456789".getBytes(StandardCharsets.UTF_8));
    }
    assertThat(file).hasContent("0123456789");
  }

  @Test
  void rotationThatFailsLosesNothingPrintedLater() throws Exception {
    Path file = temp.resolve("g.log");
    Files.createDirectories(temp.resolve("g.log.1").resolve("in the way"));
    try (RotatingFileOutputStream out = new RotatingFileOutputStream(file, 5, 1)) {
      out.write("aaaa".getBytes(StandardCharsets.UTF_8));
      assertThatExceptionOfType(IOException.class)
          .isThrownBy(() -> out.write("bbbb".getBytes(StandardCharsets.UTF_8)));
      Files.delete(temp.resolve("g.log.1").resolve("in the way"));
      out.write("cccc".getBytes(StandardCharsets.UTF_8));
    }
    assertThat(file).hasContent("cccc");
  }

  @Test
  void lockIsForOneAndIsFreeWhenClosed() throws Exception {
    Path file = temp.resolve("g.lock");
    try (ProcessLock lock = ProcessLock.acquire(file, "this group")) {
      assertThat(lock).isNotNull();
      assertThat(file).hasContent(Long.toString(ProcessHandle.current().pid()));
      assertThatExceptionOfType(IOException.class)
          .isThrownBy(() -> ProcessLock.acquire(file, "this group").close())
          .withMessage(
              "process %s of user %s still owns this group (it holds %s); a second one is refused"
                  + " until that one has ended",
              ProcessHandle.current().pid(), PrivateFiles.user().getName(), file);
    }
    ProcessLock.acquire(file, "this group").close();
  }

  @Test
  void lockFileIsItsOwnersOnlyAlsoWhereAFormerVersionMadeIt() throws Exception {
    Path made = temp.resolve("made.lock");
    ProcessLock.acquire(made, "this group").close();
    assertThat(mode(made)).isEqualTo("rw-------");

    Path former = temp.resolve("former.lock");
    Files.writeString(former, "1");
    Files.setPosixFilePermissions(former, PosixFilePermissions.fromString("rw-r--r--"));
    ProcessLock.acquire(former, "this group").close();
    assertThat(mode(former)).isEqualTo("rw-------");
  }

  @Test
  void outputIsItsOwnersOnlyAlsoAfterItMovedOn() throws Exception {
    Path file = temp.resolve("g.log");
    try (RotatingFileOutputStream out = new RotatingFileOutputStream(file, 3, 1)) {
      out.write("aaa".getBytes(StandardCharsets.UTF_8));
      out.write("bbb".getBytes(StandardCharsets.UTF_8));
    }
    assertThat(mode(file)).isEqualTo("rw-------");
    assertThat(mode(temp.resolve("g.log.1"))).isEqualTo("rw-------");
  }

  @Test
  void journalsFolderIsItsOwnersOnly() throws Exception {
    Path journal = temp.resolve("state/journal");
    Journal.open(journal, 200).close();
    assertThat(mode(journal)).isEqualTo("rwx------");
    assertThat(mode(journal.getParent())).isEqualTo("rwx------");
    assertThat(mode(journal.resolve("phoenix.lock"))).isEqualTo("rw-------");
  }

  private static String mode(Path path) throws IOException {
    return PosixFilePermissions.toString(Files.getPosixFilePermissions(path));
  }

  @Test
  void commandHasTheOptionsOfThisJavaThenTheDescriptorsThenThePropertiesThenTheDaemons()
      throws Exception {
    PhoenixConfiguration configuration =
        PhoenixConfiguration.read(
            new ConfigurationFile(
                new java.io.StringReader(
                    "org.dfra.river.phoenix { persistenceDirectory = \"/j\";"
                        + " groupOptions = new String[] { \"-Ddaemon=1\" }; }"),
                new String[0]),
            SecretIdentities.fresh());
    Properties properties = new Properties();
    properties.setProperty("robot", "atrv1");
    UUID daemon = UUID.randomUUID();
    assertThat(
            GroupProcess.command(
                daemon,
                "1-gps",
                new ActivationGroupDesc(
                    properties,
                    new ActivationGroupDesc.CommandEnvironment(
                        null, new String[] {"-Xmx64m", "-cp", "x"})),
                configuration))
        .containsExactly(
            ExecPolicy.ownJava(),
            "-Dorg.dfra.phoenix.group=" + daemon + "/1-gps",
            "-XX:+UnlockDiagnosticVMOptions",
            "-XX:ArchiveRelocationMode=0",
            "-Xmx64m",
            "-cp",
            "x",
            "-Drobot=atrv1",
            "-Ddaemon=1",
            "-Dorg.dfra.phoenix.lock=/j/1-gps.lock",
            "-Dorg.dfra.phoenix.output=/j/output/1-gps.log",
            GroupVm.class.getName());
  }

  @Test
  void senselessRestartTimesAreAFaultOfTheConfiguration() {
    assertThatExceptionOfType(net.jini.config.ConfigurationException.class)
        .isThrownBy(
            () ->
                PhoenixConfiguration.read(
                    new ConfigurationFile(
                        new java.io.StringReader(
                            "org.dfra.river.phoenix { persistenceDirectory = \"/j\";"
                                + " restartDelay = 60000L; }"),
                        new String[0]),
                    SecretIdentities.fresh()))
        .withMessageContaining("restartDelay PT1M > restartMaxDelay PT10S");
  }
}
