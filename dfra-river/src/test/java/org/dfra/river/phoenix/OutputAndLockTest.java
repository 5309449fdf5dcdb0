package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationGroupDesc;
import java.util.List;
import java.util.Properties;
import java.util.UUID;
import java.util.stream.Stream;
import net.jini.config.ConfigurationFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The files and the command of a group's process. */
class OutputAndLockTest {

  @TempDir Path temp;

  @Test
  void fullOutputMovesOnAndOnlySoManyAreKept() throws Exception {
    Path file = temp.resolve("g.log");
    try (RotatingOutput out = new RotatingOutput(file, 10, 2)) {
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
    try (RotatingOutput out = new RotatingOutput(file, 12, 1)) {
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
    try (RotatingOutput out = new RotatingOutput(file, 3, 1)) {
      out.write("0123456789".getBytes(StandardCharsets.UTF_8));
    }
    assertThat(file).hasContent("0123456789");
  }

  @Test
  void rotationThatFailsLosesNothingPrintedLater() throws Exception {
    Path file = temp.resolve("g.log");
    Files.createDirectories(temp.resolve("g.log.1").resolve("in the way"));
    try (RotatingOutput out = new RotatingOutput(file, 5, 1)) {
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
    try (GroupLock lock = GroupLock.take(file, "this group")) {
      assertThat(lock).isNotNull();
      assertThat(file).hasContent(Long.toString(ProcessHandle.current().pid()));
      assertThatExceptionOfType(IOException.class)
          .isThrownBy(() -> GroupLock.take(file, "this group").close())
          .withMessage(
              "process %s still owns this group (it holds %s); a second one is refused until that"
                  + " one has ended",
              ProcessHandle.current().pid(), file);
    }
    GroupLock.take(file, "this group").close();
  }

  @Test
  void commandHasTheDescriptorsOptionsThenThePropertiesThenTheDaemonsOptions() throws Exception {
    PhoenixConfiguration configuration =
        PhoenixConfiguration.read(
            new ConfigurationFile(
                new java.io.StringReader(
                    "org.dfra.river.phoenix { persistenceDirectory = \"/j\";"
                        + " groupOptions = new String[] { \"-Ddaemon=1\" }; }"),
                new String[0]));
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
                        new String[0])))
        .withMessageContaining("restartDelay PT1M > restartLongestDelay PT10S");
  }
}
