package org.dfra.build;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.dfra.build.ScriptFolder.program;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * {@code ./dfra} runs what was built last and waits for no build, and a build takes nothing from
 * what runs. The script runs in a folder of its own with a build tool and a Java that only pretend:
 * the tool makes a jar of the sources' text unless they contain an error or it is held up, Java
 * prints the jar it was given.
 */
@Timeout(120)
class RunVerbsTest {

  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final String OLDER =
      "dfra: these jars are older than the sources; type ./dfra build to create new ones\n";
  private static final String BUILDING = "dfra: building … (log: target/build.log)\n";

  private static final String BUILD_TOOL =
      """
      #!/bin/sh
      case $1 in
          -v) echo "Apache Maven 3.9.9"; exit ;;
          --version) echo "Gradle 8.7"; exit ;;
      esac
      echo built >>tools/builds
      while [ -e tools/hold ]; do sleep 0.05; done
      ! grep -q error dfra-cli/src/main/App.java || { echo "App.java: error"; exit 1; }
      out=target activation=target
      [ "$DFRA_BUILD" = maven ] || { out=build; activation=build/libs; }
      mkdir -p "dfra-cli/$out/lib/dl" "dfra-flight/$out/lib" "dfra-benchmarks/$out/lib/dl" "dfra-activation/$activation"
      echo core | tee "dfra-cli/$out/lib/dfra-core.jar" "dfra-flight/$out/lib/dfra-core.jar" >"dfra-benchmarks/$out/lib/dfra-core.jar"
      echo flight | tee "dfra-flight/$out/lib/dfra-flight.jar" >"dfra-benchmarks/$out/lib/dfra-flight.jar"
      cp dfra-cli/src/main/App.java "dfra-cli/$out/lib/dfra-cli.jar"
      cp dfra-cli/src/main/App.java "dfra-benchmarks/$out/lib/dfra-cli.jar"
      echo benchmarks >"dfra-benchmarks/$out/lib/dfra-benchmarks.jar"
      echo boot >"dfra-activation/$activation/dfra-activation.jar"
      """;

  /** Says which jar it was given; {@code up} stays and says it again at its end. */
  private static final String JAVA =
      """
      #!/bin/sh
      for each in "$@"; do
          case $each in
              -Ddfra.lib=*) lib=${each#-Ddfra.lib=} ;;
              -Xbootclasspath/a:*) boot=${each#-Xbootclasspath/a:} ;;
              org.dfra.*) echo "$each" >"$HOME/main" ;;
              up) up=true ;;
          esac
      done
      [ -f "$boot" ] || { echo "no boot jar"; exit 9; }
      jar=$lib/dfra-cli.jar
      [ -f "$jar" ] || jar=$lib/dfra-app.jar
      echo "runs $(cat "$jar")"
      if [ "${up:-}" ]; then
          while [ ! -e "$HOME/end" ]; do sleep 0.05; done
          echo "still $(cat "$jar")"
      fi
      """;

  /** Is asked which processes are robots': those in the folder of this test, not the computer's. */
  private static final String GREP =
      """
      #!/bin/sh
      if [ "$1" = -lsF ]; then
          cat >/dev/null
          ls "$HOME"/proc/*/cmdline 2>/dev/null
      else
          PATH=${PATH#*:}
          exec grep "$@"
      fi
      """;

  /** Takes down that it was called, and installs nothing. */
  private static final String INSTALLER =
      """
      #!/bin/sh
      echo "$*" >>"$HOME/installed"
      """;

  private static final String SUDO =
      """
      #!/bin/sh
      shift
      exec "$@"
      """;

  @TempDir Path folder;
  private ScriptFolder scripts;
  private Path source;
  private Path tools;
  private Path jars;
  private String tool = "maven";
  private final List<Process> started = new ArrayList<>();

  @BeforeEach
  void prepare() throws IOException {
    scripts = new ScriptFolder(folder, BUILD_TOOL);
    Files.writeString(folder.resolve("pom.xml"), "<project/>");
    source = Files.createDirectories(folder.resolve("dfra-cli/src/main")).resolve("App.java");
    Files.writeString(source, "version 1\n");
    tools = scripts.tools();
    program(tools.resolve("grep"), GREP);
    program(tools.resolve("apt-get"), INSTALLER);
    program(tools.resolve("sudo"), SUDO);
    Path jdk = Files.createDirectories(folder.resolve("jdk/bin"));
    program(jdk.resolve("java"), JAVA);
    program(jdk.resolve("javac"), JAVA);
    Files.writeString(folder.resolve("jdk/release"), "JAVA_VERSION=\"17.0.1\"\n");
    jars = folder.resolve(".dfra/jars");
  }

  @AfterEach
  void end() throws IOException {
    Files.deleteIfExists(tools.resolve("hold"));
    Files.writeString(folder.resolve("end"), "");
    started.forEach(each -> assertThat(ended(each)).isTrue());
  }

  private static boolean ended(Process process) {
    try {
      return process.waitFor(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  private Process start(String... words) throws IOException {
    Path output = Files.createTempFile(folder, "said", ".txt");
    ProcessBuilder builder = scripts.script(tool, words).redirectOutput(output.toFile());
    builder.environment().put("JAVA_HOME", folder.resolve("jdk").toString());
    builder.environment().put("HOME", folder.toString());
    Process script = builder.start();
    script.getOutputStream().close();
    started.add(script);
    output(script, output);
    return script;
  }

  private final Map<Process, Path> output = new java.util.HashMap<>();

  private void output(Process script, Path file) {
    output.put(script, file);
  }

  private String output(Process script) throws IOException {
    return Files.readString(output.get(script));
  }

  /** What {@code ./dfra} says to these words; it has to end by itself. */
  private String dfra(String... words) throws IOException {
    Process script = start(words);
    assertThat(ended(script)).as("./dfra %s has ended", List.of(words)).isTrue();
    return output(script);
  }

  private int builds() throws IOException {
    Path count = tools.resolve("builds");
    return Files.exists(count) ? Files.readAllLines(count).size() : 0;
  }

  private List<Path> copies() throws IOException {
    try (Stream<Path> all = Files.list(jars)) {
      return all.filter(each -> !Files.isSymbolicLink(each)).sorted().toList();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"maven", "gradle"})
  void buildsAtTheFirstStartAndNeverAgainByItself(String with) throws Exception {
    tool = with;
    String log = "dfra: building … (log: " + (with.equals("maven") ? "target" : "build");
    assertThat(dfra("status")).isEqualTo(log + "/build.log)\nruns version 1\n");
    assertThat(dfra("status")).isEqualTo("runs version 1\n");
    Files.writeString(source, "version 2\n");
    assertThat(dfra("status")).isEqualTo(OLDER + "runs version 1\n");
    assertThat(builds()).isOne();
    assertThat(dfra("build")).isEqualTo(log + "/build.log)\n");
    assertThat(dfra("status")).isEqualTo("runs version 2\n");
    assertThat(dfra("build")).isEqualTo("dfra: the jars are up to date; nothing is built\n");
    assertThat(builds()).isEqualTo(2);
  }

  @Test
  void stopsWithAnErrorInTheSourcesAndSaysTheirAgeAfterwards() throws Exception {
    dfra("build");
    Files.writeString(source, "an error\n");
    Process build = start("build");
    assertThat(ended(build)).isTrue();
    assertThat(build.exitValue()).isEqualTo(1);
    assertThat(output(build)).contains("dfra: the build failed; the log is ");
    assertThat(dfra("stop", "--all")).isEqualTo("runs version 1\n" + OLDER);
    assertThat(builds()).isEqualTo(2);
  }

  @Test
  void stopsWhileAnotherBuilds() throws Exception {
    dfra("build");
    Files.writeString(source, "version 2\n");
    Files.createFile(tools.resolve("hold"));
    Process build = start("build");
    await().atMost(PATIENCE).until(() -> builds() == 2);
    assertThat(dfra("stop", "--all")).isEqualTo("runs version 1\n" + OLDER);
    assertThat(dfra("status")).isEqualTo(OLDER + "runs version 1\n");
    assertThat(build.isAlive()).as("the build is held up").isTrue();
    Files.delete(tools.resolve("hold"));
    assertThat(ended(build)).isTrue();
    assertThat(output(build)).isEqualTo(BUILDING);
    assertThat(dfra("status")).isEqualTo("runs version 2\n");
  }

  @Test
  void stopsWhileTestsRun() throws Exception {
    dfra("build");
    Files.writeString(source, "version 2\n");
    Files.createFile(tools.resolve("hold"));
    Process tests = start("test");
    await().atMost(PATIENCE).until(() -> builds() == 2);
    assertThat(dfra("stop", "--all")).isEqualTo("runs version 1\n" + OLDER);
    assertThat(dfra("status")).isEqualTo(OLDER + "runs version 1\n");
    assertThat(tests.isAlive()).as("the tests are held up").isTrue();
    Files.delete(tools.resolve("hold"));
    assertThat(ended(tests)).isTrue();
    assertThat(output(tests)).startsWith("dfra: testing on Java 17 at ");
  }

  @Test
  void stopsWhereNothingCanBeBuilt() throws Exception {
    dfra("build");
    Files.writeString(source, "version 2\n");
    Files.delete(folder.resolve("jdk/bin/javac"));
    Files.delete(tools.resolve("mvn"));
    assertThat(dfra("stop", "--all")).isEqualTo("runs version 1\n" + OLDER);
  }

  /** What it says where it cannot do it: one line. */
  private String refused(String... words) throws IOException {
    Process script = start(words);
    assertThat(ended(script)).isTrue();
    assertThat(script.exitValue()).as(output(script)).isEqualTo(69);
    return output(script);
  }

  @ParameterizedTest
  @ValueSource(strings = {"status", "up", "demo", "help"})
  void whatOnlyRunsInstallsNothing(String verb) throws Exception {
    program(tools.resolve("mvn"), "#!/bin/sh\nexit 1\n");
    assertThat(refused(verb))
        .isEqualTo(
            "dfra: nothing is built here, and Maven 3.8 or newer is missing to build it; type"
                + " ./dfra build, which installs it or says how, then ./dfra "
                + verb
                + " again\n");
    assertThat(folder.resolve("installed")).doesNotExist();
    assertThat(refused("build")).contains("installing it with apt-get");
    assertThat(Files.readString(folder.resolve("installed"))).contains("install -y", "maven");
  }

  @Test
  void stopSaysInOneSentenceThatNothingIsBuilt() throws Exception {
    assertThat(refused("stop", "--all"))
        .isEqualTo(
            "dfra: NOTHING IS STOPPED, since nothing is built here and no robot of this computer"
                + " runs from jars that can be read: use the robots' own emergency stop, then type"
                + " ./dfra build and ./dfra stop again\n");
    assertThat(builds()).isZero();
    assertThat(folder.resolve("installed")).doesNotExist();
  }

  /** Also those of an earlier DFRA, whose verbs were in another jar and another class. */
  @ParameterizedTest
  @CsvSource({"dfra-cli.jar, org.dfra.cli.Main", "dfra-app.jar, org.dfra.app.Main"})
  void stopRunsTheJarsOfThisComputersPhoenixWhereNothingIsBuilt(String jar, String main)
      throws Exception {
    Path lib = Files.createDirectories(folder.resolve("elsewhere/lib"));
    Files.writeString(lib.resolve(jar), "the phoenix's version\n");
    Path boot = Files.writeString(lib.resolve("dfra-activation.jar"), "boot");
    Path process = Files.createDirectories(folder.resolve("proc/4711"));
    Files.writeString(
        process.resolve("cmdline"),
        String.join(
            "\0",
            "java",
            "-Xbootclasspath/a:" + boot,
            "-cp",
            lib.resolve("a.jar") + ":" + lib.resolve(jar) + ":" + lib.resolve("z.jar"),
            "org.dfra.river.phoenix.Phoenix",
            "--port=1198",
            ""));
    assertThat(dfra("stop", "--all")).isEqualTo("runs the phoenix's version\n");
    assertThat(folder.resolve("main")).hasContent(main);
    assertThat(builds()).isZero();
  }

  @Test
  void leavesWhatRunsItsJarsHoweverOftenIsBuilt() throws Exception {
    dfra("build");
    Process robot = start("up");
    await().atMost(PATIENCE).until(() -> output(robot).equals("runs version 1\n"));
    for (int version = 2; version <= 4; version++) {
      Files.writeString(source, "version " + version + "\n");
      dfra("build");
    }
    assertThat(copies()).as("that of the robot, the last and the one before").hasSize(3);
    Files.createFile(folder.resolve("end"));
    assertThat(ended(robot)).isTrue();
    assertThat(output(robot)).isEqualTo("runs version 1\nstill version 1\n");

    Files.writeString(source, "version 5\n");
    dfra("build");
    assertThat(copies()).as("the last and the one before").hasSize(2);
    assertThat(dfra("status")).isEqualTo("runs version 5\n");
  }

  /** Its own {@code clean} removes all that a build tool has written. */
  @ParameterizedTest
  @ValueSource(strings = {"maven", "gradle"})
  void leavesWhatRunsItsJarsAlsoWhereTheBuildToolCleansUp(String with) throws Exception {
    tool = with;
    dfra("build");
    Process robot = start("up");
    await().atMost(PATIENCE).until(() -> output(robot).equals("runs version 1\n"));
    for (String outputs :
        List.of(
            "target",
            "build",
            "dfra-cli/target",
            "dfra-cli/build",
            "dfra-benchmarks",
            "dfra-activation")) {
      remove(folder.resolve(outputs));
    }
    Files.createFile(folder.resolve("end"));
    assertThat(ended(robot)).isTrue();
    assertThat(output(robot)).isEqualTo("runs version 1\nstill version 1\n");
    assertThat(dfra("stop", "--all")).isEqualTo("runs version 1\n");
    assertThat(builds()).isOne();
  }

  private static void remove(Path tree) throws IOException {
    if (Files.exists(tree)) {
      try (Stream<Path> all = Files.walk(tree)) {
        for (Path each : all.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(each);
        }
      }
    }
  }

  @Test
  void keepsJarsThatAPhoenixMayStartAfterAReboot() throws Exception {
    dfra("build");
    Path first = copies().get(0);
    Path journal = Files.createDirectories(folder.resolve("state/journal"));
    Path log = Files.writeString(journal.resolve("log"), "\0\5-cp\0" + first + "/lib/a.jar\1");
    Files.writeString(first.resolve("states/1"), journal.getParent() + "\n");
    for (int version = 2; version <= 3; version++) {
      Files.writeString(source, "version " + version + "\n");
      dfra("build");
    }
    assertThat(copies()).as("the journal names the first").hasSize(3).contains(first);
    Files.writeString(log, "nothing");
    Files.writeString(source, "version 4\n");
    dfra("build");
    assertThat(copies()).hasSize(2).doesNotContain(first);
  }

  @ParameterizedTest
  @ValueSource(strings = {"maven", "gradle"})
  void packsWhatARobotNeedsAndAllOnlyWhereThatIsAsked(String with) throws Exception {
    tool = with;
    Path pack = folder.resolve("src/dist/pack");
    program(pack, "#!/bin/sh\n(cd \"$1\" && echo *.jar dl* \"${4:-}\")\n");
    assertThat(dfra("dist")).endsWith("\ndfra-cli.jar dfra-core.jar dl \n");
    assertThat(dfra("dist", "--flight"))
        .isEqualTo("dfra-cli.jar dfra-core.jar dfra-flight.jar dl -flight\n");
    assertThat(dfra("dist", "--complete"))
        .isEqualTo("dfra-benchmarks.jar dfra-cli.jar dfra-core.jar dfra-flight.jar dl -complete\n");
    assertThat(dfra("dist", "--flight", "--complete"))
        .isEqualTo(
            "dfra: --flight and --complete exclude each other; usage: ./dfra dist [--flight|--complete]"
                + " [--sign=FILE [--sign-passphrase-file=FILE]]\n");
    assertThat(dfra("dist", "--sign=none.p12"))
        .isEqualTo(
            "dfra: there is no key store none.p12; make one with: ./dfra security issue code NAME\n");
    try (Stream<Path> left =
        Files.list(folder.resolve(with.equals("maven") ? "target" : "build"))) {
      assertThat(left.map(each -> each.getFileName().toString()))
          .noneMatch(each -> each.startsWith("robot."));
    }
  }

  @Test
  void clearsAwayWhatAKilledBuildHasLeft() throws Exception {
    Files.createDirectories(jars.resolve("new.1/lib"));
    Files.createSymbolicLink(jars.resolve("new.current"), Path.of("new.1"));
    assertThat(dfra("status")).isEqualTo(BUILDING + "runs version 1\n");
    assertThat(copies()).hasSize(1);
  }
}
