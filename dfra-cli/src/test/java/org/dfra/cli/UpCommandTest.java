package org.dfra.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.RobotXml;
import org.dfra.core.robot.RobotDryRun;
import org.dfra.report.terminal.ExitCode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;

/** What {@code ./dfra up} refuses: before anything starts, in one sentence for each fault. */
class UpCommandTest {

  private static final Path CONFIG = Path.of(System.getProperty("dfra.root"), "config");

  @TempDir Path folder;

  /** A robot of one module, described from line 4 on. */
  private Path robot(String module) throws IOException {
    return Files.writeString(
        folder.resolve("robot.xml"),
        """
        <robot xmlns="urn:dfra:robot:1" name="eta" host="127.0.0.1">
          <group name="lookup"><registrar port="4999"/></group>
          <group name="all">
        %s
          </group>
        </robot>
        """
            .formatted(module));
  }

  /** A module of the properties that come with DFRA, its parameter in line 5. */
  private static String module(String name, String properties, String parameter, String value) {
    return """
    <module name="%s" properties="%s">
    <parameter name="%s" value="%s"/>
    </module>\
    """
        .formatted(
            name, CONFIG.resolve("modules").resolve(properties + ".properties"), parameter, value);
  }

  @Test
  void twoDescriptionsOfOneRobotAreRefused() throws IOException {
    Path one = robot(module("gps", "m12plus", "link", "tcp://localhost:1"));
    Path other = Files.copy(one, folder.resolve("other.xml"));
    StringWriter err = new StringWriter();
    CommandLine line = Main.commandLine().setErr(new PrintWriter(err));
    String state = "--state=" + folder.resolve("state");
    assertThat(line.execute("up", one.toString(), other.toString(), state))
        .isEqualTo(ExitCode.FAILED);
    assertThat(err)
        .hasToString(
            "dfra: "
                + other
                + ": robot eta is described in "
                + one
                + " too; give one of the two another name"
                + System.lineSeparator());
    assertThat(folder.resolve("state")).doesNotExist();
  }

  /** What it says on standard error, line by line; nothing is begun. */
  private List<String> refused(String module) throws IOException {
    return refused(robot(module));
  }

  private List<String> refused(Path... robots) throws IOException {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    CommandLine line = Main.commandLine();
    line.setOut(new PrintWriter(out, true));
    line.setErr(new PrintWriter(err, true));
    Path state = folder.resolve("state");
    List<String> words = new ArrayList<>(List.of("up", "--state=" + state));
    Stream.of(robots).forEach(each -> words.add(each.toString()));
    int exit = line.execute(words.toArray(String[]::new));
    assertThat(exit).as(err.toString()).isEqualTo(ExitCode.FAILED);
    assertThat(out.toString()).isEmpty();
    assertThat(state).as("what phoenix keeps").doesNotExist();
    return err.toString().lines().toList();
  }

  private String at(int line) {
    return "dfra: " + folder.resolve("robot.xml") + ":" + line + ": ";
  }

  @Test
  void refusesClassesThatAreNotThere() throws IOException {
    String named =
        "<module name=\"range_filter\" server=\"org.dfra.river.server.%s\""
            + " proxy=\"org.dfra.river.proxy.%s\" implementation=\"org.dfra.behaviors.%s\"/>";
    String driver = "perceptual.range.RangeFilterImpl";
    String missing = " is not on the group's class path; add its jar or correct the name";
    assertThat(
            refused(
                named.formatted(
                    "schema.RangeFilterServer", "schema.RangeFilterProxy", "SonarFilterImpl")))
        .containsExactly(
            at(4)
                + "module eta/range_filter: driver class org.dfra.behaviors.SonarFilterImpl"
                + missing);
    assertThat(refused(named.formatted("SonarServer", "schema.RangeFilterProxy", driver)))
        .containsExactly(
            at(4)
                + "module eta/range_filter: server class org.dfra.river.server.SonarServer"
                + missing);
    assertThat(refused(named.formatted("schema.RangeFilterServer", "SonarProxy", driver)))
        .containsExactly(
            at(4)
                + "module eta/range_filter: proxy class org.dfra.river.proxy.SonarProxy"
                + missing);
  }

  @Test
  void refusesParametersThatADriverDoesNotKnow() throws IOException {
    assertThat(
            refused(
                """
                <module name="gps" properties="%s">
                <parameter name="link" value="tcp://127.0.0.1:1"/>
                <parameter name="reopen_inital_delay" value="1"/>
                </module>\
                """
                    .formatted(CONFIG.resolve("modules/m12plus.properties"))))
        .containsExactly(
            at(6)
                + "eta/gps has no parameter \"reopen_inital_delay\"; did you mean \"reopen_initial_delay\"?");
    assertThat(refused(module("range_filter", "range-filter", "median_scan", "7")))
        .containsExactly(
            at(5)
                + "eta/range_filter has no parameter \"median_scan\"; did you mean \"median_scans\"?");
    assertThat(refused(module("fuzzy_drive", "fuzzy-drive", "colour", "red")))
        .containsExactly(
            at(5)
                + "eta/fuzzy_drive has no parameter \"colour\"; it has max_speed, max_yaw_rate,"
                + " system_file");
    assertThat(refused(module("raster_search", "raster-search", "resume_after_crash", "perhaps")))
        .singleElement()
        .asString()
        .startsWith(at(5) + "eta/raster_search: parameter resume_after_crash is \"perhaps\"");
    assertThat(refused(module("range_filter", "range-filter", "max_range", "far")))
        .singleElement()
        .asString()
        .startsWith(at(5) + "eta/range_filter: parameter max_range is \"far\"");
  }

  @Test
  void refusesFilesThatAreNotThere() throws IOException {
    assertThat(refused("<module name=\"range_filter\" properties=\"sonar.properties\"/>"))
        .containsExactly(
            at(4)
                + "the properties file \"sonar.properties\" of module range_filter does not exist;"
                + " name one, relative to "
                + folder.resolve("robot.xml"));
    assertThat(refused(module("fuzzy_drive", "fuzzy-drive", "system_file", "nowhere.fis")))
        .containsExactly(
            at(5)
                + "the system_file file \"nowhere.fis\" of module fuzzy_drive does not exist; name"
                + " one, relative to "
                + folder.resolve("robot.xml"));
  }

  @Test
  void refusesAFuzzySystemThatLacksInputs() throws IOException {
    String whole = Files.readString(CONFIG.resolve("fuzzy/waypoint.fis"));
    Path fis =
        Files.writeString(folder.resolve("drive.fis"), whole.replace("'centre'", "'middle'"));
    assertThat(refused(module("fuzzy_drive", "fuzzy-drive", "system_file", "drive.fis")))
        .singleElement()
        .asString()
        .startsWith("dfra: " + fis)
        .contains("a waypoint controller needs the inputs left, centre, right, heading_error")
        .contains("add centre", "middle");
  }

  @Test
  void reportsAllThatIsWrongWithARobot() throws IOException {
    assertThat(
            refused(
                module("range_filter", "range-filter", "median_scan", "7")
                    + module("heading_error", "heading-error", "lookahead", "0")))
        .hasSize(2);
  }

  @Test
  void reportsAWrongValueAndAMisspeltParameterOfOneModuleTogether() throws IOException {
    String both =
        """
        <module name="range_filter" properties="%s">
        <parameter name="max_rnge" value="8"/>
        <parameter name="max_range" value="8m"/>
        <parameter name="median_scans" value="laser"/>
        <parameter name="obstacle_memory" value="long"/>
        </module>\
        """
            .formatted(CONFIG.resolve("modules/range-filter.properties"));
    List<String> refused = refused(both);
    assertThat(refused).hasSize(4);
    assertThat(String.join("\n", refused))
        .contains(
            ":5: eta/range_filter has no parameter \"max_rnge\"; did you mean \"max_range\"?",
            ":6: eta/range_filter: parameter max_range is \"8m\", which is not a number",
            ":7: eta/range_filter: parameter median_scans is \"laser\", which is not a number",
            ":8: eta/range_filter: parameter obstacle_memory is \"long\", which is not a number");
  }

  @Test
  void reportsWhatIsWrongWithSeveralRobotsTogether() throws IOException {
    Path other = Files.createDirectory(folder.resolve("other")).resolve("theta.xml");
    Files.writeString(
        other,
        """
        <robot xmlns="urn:dfra:robot:1" name="theta" host="127.0.0.1">
        <gruop name="one"/>
        </robot>
        """);
    Path first = robot(module("range_filter", "range-filter", "max_rnge", "8"));
    for (List<Path> order : List.of(List.of(other, first), List.of(first, other))) {
      assertThat(String.join("\n", refused(order.toArray(Path[]::new))))
          .contains(other + ":2: ", "gruop", "has no parameter \"max_rnge\"");
    }
  }

  static Stream<Path> properties() throws IOException {
    try (Stream<Path> all = Files.list(CONFIG.resolve("modules"))) {
      return all.sorted().toList().stream();
    }
  }

  /** Those that are set, and those that a comment shows how to set. */
  @ParameterizedTest
  @MethodSource("properties")
  void refusesNoParameterThatAFileOfPropertiesNames(Path file) throws IOException {
    String text = Files.readString(file);
    Path whole =
        Files.writeString(
            folder.resolve("whole.properties"),
            text.replace("\n#parameter.", "\nparameter.").replace("=../", "=" + CONFIG + "/"));
    String ofXml =
        Pattern.compile("<parameter name=.*?/>")
            .matcher(text)
            .results()
            .map(MatchResult::group)
            .collect(Collectors.joining());
    Path robot = robot("<module name=\"m\" properties=\"%s\">%s</module>".formatted(whole, ofXml));
    assertThat(faults(robot)).allMatch(fault -> fault.contains("is not the name of a"), "alone");
  }

  private static List<String> faults(Path robot) {
    try {
      RobotDryRun.check(RobotXml.read(robot, name -> "secret"));
      return List.of();
    } catch (ConfigurationException e) {
      return e.getMessage().lines().toList();
    }
  }

  @Test
  void refusesNoneOfTheRobotsThatComeWithDfra() throws IOException {
    List<Path> robots;
    try (Stream<Path> all = Files.walk(CONFIG)) {
      robots = all.filter(UpCommandTest::isRobot).sorted().toList();
    }
    assertThat(robots).hasSizeGreaterThan(4);
    for (Path each : robots) {
      assertThatCode(() -> RobotDryRun.check(RobotXml.read(each, name -> null)))
          .as("%s", each)
          .doesNotThrowAnyException();
    }
  }

  private static boolean isRobot(Path file) {
    try {
      return file.toString().endsWith(".xml") && Files.readString(file).contains("<robot xmlns=");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
