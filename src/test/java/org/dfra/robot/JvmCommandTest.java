package org.dfra.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.dfra.river.bootstrap.JvmCommand;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class JvmCommandTest {

  @TempDir Path folder;

  @Test
  void startsAChildThatHasWhatThisOneHas() throws Exception {
    List<String> command = new ArrayList<>(List.of(JvmCommand.java()));
    command.addAll(JvmCommand.options());
    command.add(Child.class.getName());
    List<String> messages = run(command);
    assertThat(messages.get(0))
        .as("java.rmi.activation, by the boot loader")
        .isEqualTo("boot: null");
    assertThat(messages.get(1)).isEqualTo("home: " + System.getProperty("java.home"));
    assertThat(messages.subList(2, messages.size()))
        .as("a grandchild would be started just so")
        .isEqualTo(JvmCommand.options());
  }

  @Test
  void aChildStartedByHandWithRelativePathsHandsOnAbsoluteOnes() throws Exception {
    Path boot = Path.of(System.getProperty("dfra.boot-class-path"));
    Path link = Files.createSymbolicLink(folder.resolve("boot"), boot.toAbsolutePath());
    List<String> messages =
        run(
            List.of(
                JvmCommand.java(),
                "-Xbootclasspath/a:" + link.getFileName(),
                "-cp",
                "extra" + File.pathSeparator + System.getProperty("java.class.path"),
                Child.class.getName()));
    assertThat(messages.get(0)).isEqualTo("boot: null");
    assertThat(messages).contains("-Xbootclasspath/a:" + folder.toRealPath().resolve("boot"));
    assertThat(messages.get(messages.size() - 1))
        .startsWith(folder.toRealPath().resolve("extra") + File.pathSeparator);
    assertThat(messages.get(messages.size() - 1).split(File.pathSeparator))
        .allSatisfy(entry -> assertThat(Path.of(entry)).isAbsolute());
  }

  @Test
  void aChildKnowsWhereArchivesOfClassesAre() throws Exception {
    List<String> command = new ArrayList<>(List.of(JvmCommand.java()));
    command.add("-Ddfra.command-archive=archives/17.jsa");
    command.addAll(JvmCommand.options());
    command.add(Child.class.getName());
    assertThat(run(command))
        .contains(
            "-Ddfra.command-archive=" + folder.toRealPath().resolve("archives/17.jsa"),
            "-XX:ArchiveRelocationMode=0");
    command.set(1, "-ea");
    assertThat(run(command)).noneMatch(each -> each.contains("command-archive"));
  }

  private List<String> run(List<String> command) throws IOException, InterruptedException {
    Process process =
        new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).start();
    String messages = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).as(messages).isZero();
    return messages.lines().toList();
  }

  /** Says what it has, and what it would give to a child of its own. */
  static final class Child {

    private Child() {}

    public static void main(String[] args) throws ClassNotFoundException {
      Class<?> id = Class.forName("java.rmi.activation.ActivationID");
      Stream.concat(
              Stream.of("boot: " + id.getClassLoader(), "home: " + System.getProperty("java.home")),
              JvmCommand.options().stream())
          .forEach(System.out::println);
    }
  }
}
