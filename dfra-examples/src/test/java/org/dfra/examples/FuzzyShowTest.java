package org.dfra.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.dfra.cli.Main;
import org.dfra.river.bootstrap.JvmCommand;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.w3c.dom.Element;
import picocli.CommandLine;

/** {@code ./dfra fuzzy show}. */
class FuzzyShowTest {

  private static final Path ROOT = Path.of(System.getProperty("dfra.root", "."));
  private static final Path WAYPOINT = ROOT.resolve("config/fuzzy/waypoint.fis");
  private static final Path OF_OTHERS = ROOT.resolve("../shared/data/fuzzy").normalize();

  /** A Sugeno system with one input, an opposite, a weight, and two terms of one name. */
  private static final String THERMOSTAT =
      """
      [System]
      Name='thermostat'
      Type='sugeno'
      NumInputs=1
      NumOutputs=1
      NumRules=3
      AndMethod='prod'
      OrMethod='probor'
      ImpMethod='prod'
      AggMethod='sum'
      DefuzzMethod='wtaver'
      [Input1]
      Name='temperature'
      Range=[-10 40]
      NumMFs=1
      MF1='cold':'zmf',[5 20]
      [Output1]
      Name='power'
      Range=[0 2000]
      NumMFs=2
      MF1='some':'linear',[-50 1000]
      MF2='some':'constant',[0]
      [Rules]
      1, 1 (1) : 1
      -1, 2 (0.5) : 1
      0, 2 (1) : 2
      """;

  @TempDir Path folder;

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int show(Path system, String... more) {
    CommandLine line = Main.commandLine();
    line.setOut(new PrintWriter(out, true));
    line.setErr(new PrintWriter(err, true));
    return line.execute(
        Stream.concat(Stream.of("fuzzy", "show", system.toString()), Stream.of(more))
            .toArray(String[]::new));
  }

  private Path picture() {
    return folder.resolve("picture.svg");
  }

  /** Every word in the picture, and its title. */
  private List<String> words() throws Exception {
    Element svg =
        DocumentBuilderFactory.newInstance()
            .newDocumentBuilder()
            .parse(picture().toFile())
            .getDocumentElement();
    assertThat(svg.getTagName()).isEqualTo("svg");
    var texts = svg.getElementsByTagName("text");
    return Stream.iterate(0, i -> i < texts.getLength(), i -> i + 1)
        .map(i -> texts.item(i).getTextContent().strip())
        .toList();
  }

  @Test
  void drawsEachVariableWithItsTermsTheSurfacesAndAllRules() throws Exception {
    assertThat(show(WAYPOINT, "--output=" + picture())).as(err.toString()).isZero();
    List<String> words = words();
    assertThat(words)
        .contains("waypoint: Mamdani, 135 rules", "input left", "input heading_error", "output rv")
        .contains("tr at right = 4, heading_error = 0", "rv at right = 4, heading_error = 0")
        .contains("What the rules say of tr", "What the rules say of rv")
        .noneMatch(word -> word.contains("…"));
    // Each word of tr is in the legend once, and in the table for each rule that says it.
    assertThat(words.stream().filter("stop"::equals)).hasSize(1 + 9 * 5 + 2);
    assertThat(words.stream().filter("fast"::equals)).hasSize(1 + 6);
    assertThat(words.stream().filter("hard_left"::equals)).hasSize(1 + 3 * 5 + 5);
    assertThat(out.toString())
        .contains("waypoint: Mamdani, and min, or max")
        .containsPattern(
            "heading_error +input +−180 to 180 +far_right, right, ahead, left, far_left")
        .contains("135 rules")
        .endsWith("Drawn: " + picture() + System.lineSeparator());
  }

  @Test
  void drawsTheSameBytesEachTime() throws Exception {
    assertThat(show(WAYPOINT, "--output=" + picture())).isZero();
    Path other = folder.resolve("other.svg");
    assertThat(show(WAYPOINT, "--output=" + other)).isZero();
    assertThat(Files.mismatch(picture(), other)).as("first byte that differs").isEqualTo(-1);
  }

  @Test
  void drawsTheSurfacesThatAreAskedForWithTheOthersHeld() throws Exception {
    assertThat(
            show(
                WAYPOINT,
                "--output=" + picture(),
                "--surface=centre,heading_error,rv",
                "--surface=left,right",
                "--at=left=0.5",
                "--at=centre=2"))
        .as(err.toString())
        .isZero();
    assertThat(words())
        .contains("rv at left = 0.5, right = 4", "tr at centre = 2, heading_error = 0")
        .contains("rv at centre = 2, heading_error = 0")
        .doesNotContain("tr at left = 0.5, right = 4");
  }

  @Test
  void drawsASugenoSystemOfOneInput() throws Exception {
    Path system = Files.writeString(folder.resolve("thermostat.fis"), THERMOSTAT);
    assertThat(show(system, "--output=" + picture())).as(err.toString()).isZero();
    assertThat(words())
        .contains("thermostat: Sugeno, 3 rules", "power")
        .contains("some #1 = −50 · temperature + 1000", "some #2 = 0")
        .contains("1. temperature is cold: power is some #1")
        .contains("2. temperature is not cold: power is some #2 (weight 0.5)")
        .contains("3. never: power is some #2");
    assertThat(out.toString()).contains("1. temperature is cold: power is some #1");
  }

  @Test
  void printsJsonForPrograms() throws Exception {
    assertThat(show(WAYPOINT, "--json", "--output=" + picture())).isZero();
    JsonNode reported = new ObjectMapper().readTree(out.toString());
    assertThat(reported.at("/name").asText()).isEqualTo("waypoint");
    assertThat(reported.at("/operators/defuzzification").asText()).isEqualTo("centroid");
    assertThat(reported.at("/inputs/3/low").asDouble()).isEqualTo(-180);
    assertThat(reported.at("/inputs/0/terms/1/parameters/3").asDouble()).isEqualTo(2.6);
    assertThat(reported.at("/rules")).hasSize(135);
    assertThat(reported.at("/rules/0").asText())
        .isEqualTo(
            "left is close and centre is close and right is close and heading_error is far_right:"
                + " tr is stop, rv is hard_right");
    assertThat(reported.at("/surfaces/1").asText())
        .isEqualTo("rv over left and centre at right = 4, heading_error = 0");
    assertThat(Path.of(reported.at("/image").asText())).isRegularFile();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--surface=lft,centre | waypoint has no input \"lft\"; did you mean \"left\"?",
        "--surface=left,x | waypoint has no input \"x\"; there is left, centre, right, heading_error",
        "--surface=left,centre,tv | waypoint has no output \"tv\"; did you mean \"tr\"?",
        "--surface=left | --surface=left names 1; write two inputs, and an output if only one is wanted: IN1,IN2[,OUT]",
        "--surface=left,left | --surface=left,left names one input twice; name two",
        "--at=left | --at=left is not NAME=VALUE, as in --at=left=0",
        "--at=heading_eror=1 | waypoint has no input \"heading_eror\"; did you mean \"heading_error\"?",
        "--at=right=near | --at=right=near: \"near\" is not a number",
        "--at=right=1e999 | --at=right=1e999: \"1e999\" is not finite",
        "--at=left=1 | --at=left=1: left is along an axis, so it is not held",
      })
  void whatDoesNotFitTheSystemIsReportedInOneSentence(String option, String sentence) {
    assertThat(show(WAYPOINT, option, "--output=" + picture())).isEqualTo(2);
    assertThat(err.toString()).isEqualTo("dfra: " + sentence + System.lineSeparator());
    assertThat(picture()).doesNotExist();
  }

  @Test
  void aMissingOrBrokenSystemIsReportedWithItsPlace() throws Exception {
    Path missing = folder.resolve("none.fis");
    assertThat(show(missing, "--output=" + picture())).isEqualTo(1);
    assertThat(err.toString())
        .isEqualTo(
            "dfra: "
                + missing
                + ": there is no such file; name the .fis file of a fuzzy system"
                + System.lineSeparator());
    Path broken =
        Files.writeString(folder.resolve("broken.fis"), THERMOSTAT.replace("'zmf'", "'zmff'"));
    assertThat(show(broken, "--output=" + picture())).isEqualTo(1);
    assertThat(err.toString())
        .contains(
            "dfra: "
                + broken
                + ":16: the membership function type \"zmff\" is unknown; did you mean \"zmf\"?");
    assertThat(picture()).doesNotExist();
  }

  @Test
  void aPictureThatCannotBeWrittenIsReportedAndTheSystemIsNotOverwritten() throws Exception {
    Path nowhere = folder.resolve("no/such/picture.svg");
    assertThat(show(WAYPOINT, "--output=" + nowhere)).isEqualTo(1);
    assertThat(show(WAYPOINT, "--output=" + folder)).isEqualTo(1);
    Path system = Files.writeString(folder.resolve("thermostat.fis"), THERMOSTAT);
    assertThat(show(system, "--output=" + system)).isEqualTo(1);
    assertThat(err.toString().lines())
        .containsExactly(
            "dfra: "
                + nowhere
                + " cannot be written: there is no folder "
                + nowhere.getParent()
                + "; name another file with --output",
            "dfra: "
                + folder
                + " cannot be written: it is a folder; name another file with --output",
            "dfra: "
                + system
                + " cannot be written: it is the system itself; name another file with --output");
    assertThat(system).hasContent(THERMOSTAT);
  }

  @Test
  void drawsSystemsOfOthers() throws Exception {
    assumeTrue(Files.isDirectory(OF_OTHERS), "the folder with others' fuzzy systems is absent");
    List<Path> systems;
    try (Stream<Path> files = Files.list(OF_OTHERS)) {
      systems =
          files
              .filter(file -> file.getFileName().toString().matches("(?!refuse_).*\\.fis"))
              .toList();
    }
    assertThat(systems).hasSizeGreaterThan(5);
    for (Path system : systems) {
      assertThat(show(system, "--output=" + picture())).as(system + ": " + err).isZero();
      assertThat(words()).as(system.toString()).noneMatch(word -> word.contains("…"));
    }
  }

  /** What another virtual machine says and how it ends, in this environment. */
  private record Ended(int exit, String output) {}

  private Ended elsewhere(Map<String, String> environment) throws Exception {
    List<String> command = new ArrayList<>(List.of(JvmCommand.java()));
    command.addAll(JvmCommand.options());
    command.addAll(List.of("-Duser.home=" + folder, Main.class.getName(), "fuzzy", "show"));
    command.addAll(List.of(WAYPOINT.toString(), "--output=" + picture()));
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    builder.environment().putAll(environment);
    Process process = builder.start();
    try {
      String output = new String(process.getInputStream().readAllBytes());
      assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
      return new Ended(process.exitValue(), output);
    } finally {
      process.destroyForcibly();
    }
  }

  @Test
  void needsNoDisplayEvenWhereOneIsNamed() throws Exception {
    Ended ended = elsewhere(Map.of("DISPLAY", "127.0.0.1:99"));
    assertThat(ended.exit()).as(ended.output()).isZero();
    assertThat(words()).contains("input left");
  }

  @Test
  void saysWhatToInstallWhereThereIsNoFont() throws Exception {
    assumeTrue(
        System.getProperty("os.name").equals("Linux"), "fonts come from fontconfig on Linux");
    Path none =
        Files.writeString(
            folder.resolve("fonts.conf"),
            "<?xml version=\"1.0\"?><!DOCTYPE fontconfig SYSTEM \"fonts.dtd\"><fontconfig/>");
    Ended ended = elsewhere(Map.of("FONTCONFIG_FILE", none.toString()));
    assertThat(ended.exit()).isEqualTo(1);
    assertThat(ended.output())
        .startsWith("dfra: no picture can be painted, since Java finds no font here (")
        .contains("install fontconfig and a font")
        .hasLineCount(1);
    assertThat(picture()).doesNotExist();
  }
}
