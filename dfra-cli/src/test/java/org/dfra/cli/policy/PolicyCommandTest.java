package org.dfra.cli.policy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.dfra.cli.Main;
import org.dfra.report.terminal.ExitCode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** {@code ./dfra policy}, as it is typed. */
class PolicyCommandTest {

  @TempDir Path state;

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int run(String... arguments) {
    String[] all =
        Stream.concat(
                Stream.concat(Stream.of("policy"), Stream.of(arguments)),
                Stream.of("--state", state.toString()))
            .toArray(String[]::new);
    CommandLine line = Main.commandLine(all);
    line.setOut(new PrintWriter(out)).setErr(new PrintWriter(err));
    return line.execute(all);
  }

  private Path policy(String... rules) throws IOException {
    return Files.writeString(
        state.resolve("mine.xml"),
        "<policy xmlns=\"urn:dfra:policy:1\" team=\"field\" version=\"7\">\n"
            + String.join("\n", rules)
            + "\n</policy>\n");
  }

  @Test
  void checksThePolicyThatComesWithDfraAndShowsWhoMayDoWhat() {
    assertThat(run("check")).isEqualTo(ExitCode.SUCCESS);
    List<String> lines = out.toString().lines().toList();
    assertThat(lines.get(0)).isEqualTo("default-policy.xml is valid: policy 0 of field, 12 rules.");
    assertThat(json("own", "command")).isEqualTo("permit");
    assertThat(json("operator", "command")).isEqualTo("permit");
    assertThat(json("operator", "register")).isEqualTo("deny");
    assertThat(json("robot", "command")).isEqualTo("deny");
    assertThat(json("robot", "deliver")).isEqualTo("permit");
    assertThat(json("delegate", "command")).isEqualTo("permit");
    assertThat(json("delegate", "stop")).isEqualTo("permit");
    assertThat(json("delegate", "release")).isEqualTo("deny");
    assertThat(json("observer", "read")).isEqualTo("some");
    assertThat(json("expired", "stop")).isEqualTo("permit");
    assertThat(json("stranger", "stop")).isEqualTo("deny");
    assertThat(json("stranger", "services")).isEqualTo("shown");
    assertThat(json("stranger", "entry module")).isEqualTo("some");
    assertThat(json("stranger", "entry recruitment")).isEqualTo("hidden");
    assertThat(json("observer", "entry recruitment")).isEqualTo("shown");
  }

  private String explain(String who, String what, String... more) {
    out.getBuffer().setLength(0);
    String[] words = {"explain", "--who", who, "--what", what};
    assertThat(run(Stream.concat(Stream.of(words), Stream.of(more)).toArray(String[]::new)))
        .isEqualTo(ExitCode.SUCCESS);
    return out.toString().replaceAll("\\s+", " ").strip();
  }

  @Test
  void explainsWhatACallerSeesInLookupServices() throws IOException {
    assertThat(explain("stranger", "entry module.host"))
        .startsWith(
            "entry module.host for stranger: hidden by <hide> other-attributes (default-pol")
        .endsWith(").");
    assertThat(explain("stranger", "entry module"))
        .contains("robot, name, author, version, state shown by <show> public-attributes (")
        .contains("driver, host, created, activated, clients hidden by <hide> other-attributes (");
    assertThat(explain("observer otto", "entry module.host"))
        .isEqualTo(
            "entry module.host for observer otto of field: shown since no rule of policy 0 of field"
                + " hides it.");
    String file = policy("<hide name=\"all\" type=\"Effector\"/>", "<permit/>").toString();
    assertThat(explain("observer otto", "service of DriveEffector", file))
        .contains("shown since who may stop an effector must find it, whatever <hide> all (");
    assertThat(explain("stranger", "service of DriveEffector", file))
        .isEqualTo("service of DriveEffector for stranger: hidden by <hide> all (" + file + ":2).");
    assertThat(explain("stranger", "service of GPSSensor", file)).contains(": shown since no rule");
    assertThat(run("explain", "--who", "stranger", "--what", "entry modul.host"))
        .isEqualTo(ExitCode.NOT_FOUND);
    assertThat(err.toString())
        .contains("there are no attributes \"modul\"; did you mean \"module\"?");
    assertThat(run("explain", "--who", "stranger", "--what", "entry")).isEqualTo(2);
    assertThat(run("explain", "--who", "stranger", "--what", "service of Nothing"))
        .isEqualTo(ExitCode.NOT_FOUND);
  }

  /** What the summary says in JSON. */
  private String json(String caller, String kind) {
    out.getBuffer().setLength(0);
    assertThat(run("check", "--json")).isEqualTo(ExitCode.SUCCESS);
    String row = out.toString().split("\"caller\" *: *\"" + caller + "\"", 2)[1];
    return row.split("\"" + kind + "\" *: *\"", 2)[1].split("\"", 2)[0];
  }

  @Test
  void reportsEachFaultWithItsFileAndLine() throws IOException {
    Path file = policy("<permit rol=\"robot\"/>", "<permit/>", "<permit kind=\"fly\"/>");
    assertThat(run("check", file.toString())).isEqualTo(ExitCode.FAILED);
    String text = err.toString().replaceAll("\\s+", " ");
    assertThat(text)
        .contains(file + ":2: the attribute rol is not known in <permit>; did you mean \"role\"?")
        .contains(file + ":4: kind \"fly\" is none of read,");
    assertThat(out.toString()).isEmpty();
  }

  @Test
  void saysWhoseStopsAPolicyDoesNotPermit() throws IOException {
    assertThat(run("check")).isEqualTo(ExitCode.SUCCESS);
    assertThat(err.toString()).isEmpty();
    Path file =
        policy(
            "<permit role=\"operator\"><ask/></permit>",
            "<permit role=\"robot\"><when from=\"08:00\" until=\"18:00\"/></permit>");
    assertThat(run("check", file.toString())).isEqualTo(ExitCode.SUCCESS);
    assertThat(err.toString().replaceAll("\\s+", " "))
        .contains("does not always permit an emergency stop to robots, observers; unless");
  }

  @Test
  void readsThePolicyOfTheStateFolderBeforeItsOwn() throws IOException {
    Files.createDirectory(state.resolve("security"));
    Files.copy(policy("<permit role=\"observer\"/>"), state.resolve("security/policy.xml"));
    assertThat(run("check")).isEqualTo(ExitCode.SUCCESS);
    assertThat(out.toString()).contains("policy 7 of field, 1 rule.");
  }

  @Test
  void explainsWhichRuleDecidesAndWhichAlmostDid() throws IOException {
    Path file =
        policy(
            "<permit name=\"robots\" role=\"robot\"/>",
            "<deny name=\"tests\" method=\"test\" member=\"anna\"/>",
            "<deny name=\"stops\" kind=\"stop\"/>",
            "<permit name=\"unloaded\" member=\"anna\"><while fact=\"load\" is=\"none\"/></permit>",
            "<permit name=\"slowly\" member=\"a*\"><rate max=\"5\" per=\"1s\"/><log/></permit>");
    assertThat(
            run(
                "explain",
                "--who",
                "operator anna",
                "--what",
                "DriveEffector.execute",
                file.toString()))
        .isEqualTo(ExitCode.SUCCESS);
    assertThat(out.toString().replaceAll("\\s+", " "))
        .contains(
            "DriveEffector.execute (command) by operator anna of field: permitted or refused, which"
                + " depends on what follows.")
        .contains(
            "While its conditions hold, <permit> unloaded ("
                + file
                + ":5) decides: only while load"
                + " is none.")
        .contains("Otherwise <permit> slowly (" + file + ":6) decides.")
        .contains("Obligation: at most 5 calls in 1 s.")
        .contains("Obligation: it is logged.")
        .contains(
            "Before it, <permit> robots ("
                + file
                + ":2) does not match: the caller's role is operator, not robot.")
        .contains("<deny> tests (" + file + ":3) does not match: the method is execute, not test.")
        .doesNotContain("<deny> stops");
  }

  @Test
  void explainsARefusalThatNoRuleMatches() {
    assertThat(run("explain", "--who", "stranger", "--what", "DriveEffector.execute"))
        .isEqualTo(ExitCode.SUCCESS);
    assertThat(out.toString())
        .contains("DriveEffector.execute (command) by stranger: refused.")
        .contains("no rule of policy 0 of field matches, so the call is refused.");
    assertThat(run("explain", "--who", "own", "--what", "DriveEffector.execute")).isZero();
    assertThat(out.toString()).contains("permitted.").contains("<permit> own (");
  }

  @Test
  void saysWhatIsWrongWithAnArgument() {
    assertThat(run("explain", "--who", "boss anna", "--what", "DriveEffector.execute"))
        .isEqualTo(ExitCode.USAGE_ERROR);
    assertThat(err.toString())
        .contains("--who: role \"boss\" is none of robot, operator, observer");
    assertThat(run("explain", "--who", "stranger", "--what", "DriveEffector.setVelocity"))
        .isEqualTo(ExitCode.NOT_FOUND);
    assertThat(err.toString()).contains("DriveEffector has no method \"setVelocity\"");
    assertThat(run("explain", "--who", "stranger", "--what", "DriveEfector.execute"))
        .isEqualTo(ExitCode.NOT_FOUND);
    assertThat(err.toString()).contains("did you mean \"DriveEffector\"?");
    assertThat(run("explain", "--who", "anna", "--what", "execute"))
        .isEqualTo(ExitCode.USAGE_ERROR);
  }
}
