package org.dfra.river.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import org.dfra.river.fixture.TestCode;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RobotCodebaseTest {

  @TempDir static Path compiled;
  @TempDir private Path folder;

  private RobotCodebase classes(int port, List<Path> kind, List<Path> general) {
    return new RobotCodebase("127.0.0.1", port, folder.resolve("kept"), List.of(kind), general);
  }

  @BeforeAll
  static void compile() throws IOException {
    TestCode.compile(compiled, Map.of("a.B", "package a; public class B {}"));
  }

  private Path jar(String name) throws IOException {
    return TestCode.jar(folder.resolve(name), compiled);
  }

  @Test
  void theOptionsOfAGroupContainTheCodebase() throws IOException {
    Path kind = Path.of("/a/kind dl.jar");
    RobotCodebase codebase =
        new RobotCodebase(
            "fe80::1",
            8085,
            folder,
            List.of(List.of(kind), List.of(), List.of(kind), List.of(Path.of("/b.jar"), kind)),
            List.of(Path.of("/c.jar")));
    Properties properties = new Properties();
    for (String option : codebase.options(true)) {
      String[] parts = option.substring(2).split("=", 2);
      properties.setProperty(parts[0], parts[1]);
    }
    assertThat(RobotCodebase.fromProperties(properties)).contains(codebase);
    assertThat(codebase.moduleCodebases()).as("each once").hasSize(2);
    assertThat(RobotCodebase.serves(properties)).isTrue();
    assertThat(RobotCodebase.fromProperties(new Properties())).isEmpty();
    assertThat(classes(1, List.of(), List.of()).isEmpty()).isTrue();
  }

  /** Those of groups in a journal that was written before the options were renamed. */
  @Test
  void optionsByTheirFormerNamesAreUnderstood() {
    Properties properties = new Properties();
    properties.setProperty("dfra.classes", "fe80::1:8085");
    properties.setProperty("dfra.classes.serve", "true");
    properties.setProperty("dfra.classes.kept", folder.toString());
    properties.setProperty("dfra.classes.kind.0", "/a/kind-dl.jar");
    properties.setProperty("dfra.classes.kind.1", "/b.jar");
    properties.setProperty("dfra.classes.general", "/c.jar");
    assertThat(RobotCodebase.fromProperties(properties))
        .contains(
            new RobotCodebase(
                "fe80::1",
                8085,
                folder,
                List.of(List.of(Path.of("/a/kind-dl.jar")), List.of(Path.of("/b.jar"))),
                List.of(Path.of("/c.jar"))));
    assertThat(RobotCodebase.serves(properties)).isTrue();
    assertThat(
            RobotCodebase.servedPort(
                List.of("-Xmx64m", "-Ddfra.classes=h:8085", "-Ddfra.classes.serve=true")))
        .contains(8085);
  }

  @Test
  void knowsTheClassesOfAJar() throws IOException {
    assertThat(RobotCodebase.read(jar("b.jar")).classes()).containsExactly("a.B");
  }

  @Test
  void saysWhichJarCannotBeServed() throws IOException {
    Path missing = folder.resolve("missing.jar");
    assertThatThrownBy(() -> classes(1, List.of(missing), List.of()).check())
        .isInstanceOf(IOException.class)
        .hasMessageStartingWith("the jar " + missing + " cannot be served (")
        .hasMessageEndingWith("; build it first");

    Path text = Files.writeString(folder.resolve("text.jar"), "no jar");
    assertThatThrownBy(() -> classes(1, List.of(), List.of(text)).check())
        .hasMessage(
            "the jar " + text + " cannot be served: it is not a jar, or it is empty; rebuild it");

    Path one = jar("same.jar");
    Path other = Files.copy(one, Files.createDirectory(folder.resolve("sub")).resolve("same.jar"));
    assertThatThrownBy(() -> classes(1, List.of(one), List.of(other)).check())
        .hasMessage(
            "two jars to download have one name, " + one + " and " + other + "; rename one");
  }

  @Test
  void saysWhyAJarCannotBeHad() throws IOException {
    Path file = jar("b.jar");
    Path stranger = jar("stranger.jar");
    int free;
    try (ClassServer server = new ClassServer("127.0.0.1", 0, folder, List.of("b.jar"))) {
      server.start();
      free = server.port();
      assertThat(classes(server.port(), List.of(file), List.of()).findUnserved()).isEmpty();

      String place = "127.0.0.1:" + server.port();
      assertThat(classes(server.port(), List.of(stranger), List.of()).findUnserved())
          .contains(
              "clients that lack stranger.jar cannot download it from "
                  + place
                  + ": what listens there answers 404; end it, or give the robot's class server"
                  + " another port");

      Path other =
          TestCode.compile(folder.resolve("other"), Map.of("a.C", "package a; public class C {}"));
      TestCode.jar(file, other);
      assertThat(classes(server.port(), List.of(file), List.of()).findUnserved())
          .contains(
              "clients that lack b.jar cannot download it from "
                  + place
                  + ": it has other contents there; restart the registrar's group");
    }
    assertThat(classes(free, List.of(file), List.of()).findUnserved())
        .hasValueSatisfying(
            fault ->
                assertThat(fault)
                    .contains(": no class server answers (")
                    .endsWith("); see the registrar group's log"));
  }
}
