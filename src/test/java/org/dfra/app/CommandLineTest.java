package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dfra.cli.Main;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/** What the command line says to those who ask it about itself, and to those who ask wrongly. */
class CommandLineTest {

  private static final int WIDTH = 80;

  @TempDir Path folder;

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int run(String... args) {
    CommandLine line = Main.commandLine(args);
    line.setOut(new PrintWriter(out, true));
    line.setErr(new PrintWriter(err, true));
    return line.execute(args);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "frobnicate | there is no verb \"frobnicate\"; there is audit, bench, build, completion,"
            + " demo, dist, doctor, down, event, fuzzy, help, javadoc, lease, log, module, persona,"
            + " policy, recruit, security, sim, status, stop, task, test, up, whoami",
        "--frobnicate | unknown option: '--frobnicate'; see: ./dfra --help",
        "demo nonesuch"
            + " | there is no demonstration \"nonesuch\"; there is raster, recruit, devices,"
            + " persona, security, foundation; see: ./dfra demo --help",
        "demo --frobnicate | unknown option: '--frobnicate'; see: ./dfra demo --help",
        "up --port=abc" + " | --port=abc is not a whole number; see: ./dfra up --help",
        "up --port=0 | --port=0 is not a port from 1 to 65535; see: ./dfra up --help",
        "down --port=99999"
            + " | --port=99999 is not a port from 1 to 65535; see: ./dfra down --help",
        "module | module needs a verb; there is add, call, diagnose, get, info, kill, list,"
            + " recover, remove, replace, set, start, stop",
        "module lst" + " | there is no verb \"module lst\"; did you mean \"list\"?",
        "help modul | there is no verb \"modul\"; did you mean \"module\"?",
        "help module lst | there is no verb \"module lst\"; did you mean \"list\"?",
        "module list --frobnicate"
            + " | unknown option: '--frobnicate'; see: ./dfra module list --help",
        "module list --wait=-1"
            + " | --wait=-1.0 is not a number of seconds from 0 to 3600; see: ./dfra module list"
            + " --help",
        "fuzzy sho | there is no verb \"fuzzy sho\"; did you mean \"show\"?",
        "fuzzy show | missing required parameter: 'FILE.FIS'; see: ./dfra fuzzy show --help",
        "recruit | recruit needs a verb; there is experiment, resume, status",
        "recruit resume | missing required parameter: 'ROBOT'; see: ./dfra recruit resume --help",
        "recruit resume r --wait=-1"
            + " | --wait=-1.0 is not a number of seconds from 0 to 3600; see: ./dfra recruit resume"
            + " --help",
        "recruit status --frobnicate"
            + " | unknown option: '--frobnicate'; see: ./dfra recruit status --help",
        "recruit experiment --seeds=0"
            + " | --seeds=0 is not a number from 2 to 10000; see: ./dfra recruit experiment --help",
        "recruit experiment --jobs=none"
            + " | --jobs=none is not a whole number; see: ./dfra recruit experiment --help",
        "persona | persona needs a verb; there is find, list, show",
        "persona find | missing required parameter: 'QUERY'; see: ./dfra persona find --help",
        "event echo gps --kind=loud"
            + " | --kind cannot be \"loud\"; it is one of readiness, reading, parameter, incident;"
            + " see: ./dfra event echo --help",
        "event echo gps --depth=0"
            + " | depth 0 is outside 1 to 1024; see: ./dfra event echo --help",
        "event echo gps --rate=0 | rate 0.0 Hz is not above 0; see: ./dfra event echo --help",
        "event echo gps --count=0" + " | --count=0 is not 1 or more; see: ./dfra event echo --help",
        "event hz gps --for=0"
            + " | --for=0.0 is not a number of seconds above 0; see: ./dfra event hz --help",
        "event bw gps --window=1"
            + " | --window=1 is not a number from 2 to 100000; see: ./dfra event bw --help",
        "log level gps loud | LEVEL cannot be \"loud\"; it is one of trace, debug, info, warn,"
            + " error; see: ./dfra log level --help",
        "up --registry-port=-2"
            + " | --registry-port=-2 is not a port from -1 to 65535; see: ./dfra up --help",
      })
  void aUsageErrorIsReportedInOneSentence(String asked, String sentence) {
    assertThat(run(asked.split(" "))).isEqualTo(2);
    assertThat(err.toString()).isEqualTo("dfra: " + sentence + System.lineSeparator());
    assertThat(out.toString()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(strings = {"recruit status", "recruit status ugv1", "recruit resume ugv1"})
  void aMissingTeamIsReportedInOneSentence(String asked) {
    String where = " --team= --locator=127.0.0.1:1 --host=127.0.0.1 --wait=0 --state=" + folder;
    assertThat(run((asked + where).split(" "))).isEqualTo(3);
    assertThat(err.toString())
        .isEqualTo(
            "dfra: no lookup service answers (asked: jini://127.0.0.1:1); bring a robot up, name"
                + " one with --locator, or ask ./dfra doctor"
                + System.lineSeparator());
    assertThat(out.toString()).isEmpty();
  }

  @Test
  void withoutAVerbItListsItsVerbs() {
    assertThat(run()).isEqualTo(2);
    assertThat(err.toString())
        .startsWith("Usage: dfra [-hV] COMMAND")
        .contains("demo", "up", "module", "test");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--help",
        "help",
        "demo --help",
        "help demo",
        "help module call",
        "up --help",
        "module -h",
        "module call --help",
        "persona find --help",
        "event echo --help",
        "fuzzy --help",
        "fuzzy show --help",
        "recruit --help",
        "recruit experiment --help",
        "event hz --help",
        "event bw --help",
        "lease list --help",
        "lease revoke --help",
        "log level --help",
        "security --help",
        "security init --help",
        "security issue --help",
        "security join --help",
        "whoami --help"
      })
  void helpFitsATerminalAndNamesWhatThereIs(String asked) {
    assertThat(run(asked.split(" "))).isZero();
    assertThat(out.toString()).startsWith("Usage: dfra ");
    assertThat(out.toString().lines()).allSatisfy(l -> assertThat(l).hasSizeLessThan(WIDTH));
    assertThat(err.toString()).isEmpty();
  }

  @Test
  void helpNamesEveryVerb() {
    run("--help");
    assertThat(out.toString().lines().map(String::strip))
        .anyMatch(line -> line.startsWith("demo "))
        .anyMatch(line -> line.startsWith("module "))
        .anyMatch(line -> line.startsWith("help "))
        .anyMatch(line -> line.startsWith("test "));
  }

  @ParameterizedTest
  @ValueSource(strings = {"--version", "-V", "demo --version", "module list -V"})
  void versionIsOneLine(String asked) {
    assertThat(run(asked.split(" "))).isZero();
    assertThat(out.toString().strip())
        .matches("dfra (\\d+\\.\\d+\\.\\d+(-SNAPSHOT)?|of a build without a jar)");
  }

  @Test
  void aMissingRobotFileIsReportedInOneSentence() {
    Path missing = folder.resolve("nobody.xml");
    assertThat(run("up", missing.toString(), "--state=" + folder)).isEqualTo(1);
    assertThat(err.toString())
        .isEqualTo(
            "dfra: "
                + missing
                + ": there is no such file; name the XML file of a robot"
                + System.lineSeparator());
  }

  @Test
  void aRobotFileThatCannotBeReadIsReportedWithTheLine() throws Exception {
    Path broken = folder.resolve("broken.xml");
    Files.writeString(broken, "<robot xmlns=\"urn:dfra:robot:1\" name=\"r\">\n<gruop/>\n</robot>");
    assertThat(run("up", broken.toString(), "--state=" + folder)).isEqualTo(1);
    assertThat(err.toString()).startsWith("dfra: " + broken + ":2: ").contains("group");
    assertThat(folder.resolve("phoenix.log")).as("nothing was started").doesNotExist();
  }
}
