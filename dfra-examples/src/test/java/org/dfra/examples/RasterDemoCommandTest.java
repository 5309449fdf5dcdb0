package org.dfra.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.dfra.cli.Main;
import org.dfra.report.terminal.ExitCode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** What {@code ./dfra demo raster} refuses: before anything starts, in one sentence. */
class RasterDemoCommandTest {

  private static final String SQUARE =
      "48.000103,11.000215 48.000103,11.000335 48.000175,11.000335 48.000175,11.000215";

  @TempDir Path folder;

  /** What it says on standard error; it says nothing else and writes no report. */
  private String refused(int exit, String... arguments) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    CommandLine line = Main.commandLine();
    line.setOut(new PrintWriter(out, true));
    line.setErr(new PrintWriter(err, true));
    Path report = folder.resolve("report");
    int ended =
        line.execute(
            Stream.concat(Stream.of("demo"), Stream.concat(Stream.of(arguments), report(report)))
                .toArray(String[]::new));
    assertThat(ended).as(err.toString()).isEqualTo(exit);
    assertThat(out.toString()).isEmpty();
    assertThat(report).doesNotExist();
    assertThat(err.toString().strip().lines()).hasSize(1);
    return err.toString().strip();
  }

  private static Stream<String> report(Path folder) {
    return Stream.of("--report", folder.toString());
  }

  private String refusedRegion(String region) {
    return refused(ExitCode.FAILED, "raster", "--local", "--region", region);
  }

  @Test
  void refusesNumbersThatCannotBe() {
    int wrong = ExitCode.USAGE_ERROR;
    assertThat(refused(wrong, "raster", "--local", "--swath", "0"))
        .isEqualTo("dfra: --swath 0.0 is outside 0.1 to 100");
    assertThat(refused(wrong, "raster", "--local", "--swath", "NaN"))
        .isEqualTo("dfra: --swath NaN is outside 0.1 to 100");
    assertThat(refused(wrong, "raster", "--local", "--swath", "2", "--spacing", "2.1"))
        .isEqualTo("dfra: --spacing 2.1 is outside 0.1 to 2, the swath");
    assertThat(refused(wrong, "raster", "--speed", "0"))
        .isEqualTo("dfra: --speed 0.0 is outside 0.01 to 1000");
    assertThat(refused(wrong, "raster", "--local", "--seed", "one"))
        .isEqualTo("dfra: --seed=one is not a whole number; see: ./dfra demo --help");
  }

  @Test
  void refusesASpeedWhereTimeGoesByItself() {
    assertThat(refused(ExitCode.USAGE_ERROR, "raster", "--local", "--speed", "2"))
        .startsWith("dfra: --speed has no meaning with --local");
  }

  @Test
  void refusesTwoWaysAtOnce() {
    assertThat(refused(ExitCode.USAGE_ERROR, "raster", "--embedded", "--local"))
        .isEqualTo(
            "dfra: --local and --embedded are two ways to run a search in one virtual machine; omit"
                + " one of them");
  }

  @Test
  void refusesRegionsThatAreNone() {
    assertThat(refusedRegion("48,11 48.0002,11.0002 48.0002,11 48,11.0002"))
        .contains("the outline of the region crosses itself at ");
    assertThat(refusedRegion("48,11 48.0002,11.0002"))
        .contains("a region of 2 different corners encloses nothing");
    assertThat(refusedRegion("")).contains("the region is empty");
    assertThat(refusedRegion("48,11,3 48.0002,11.0002 48.0002,11"))
        .contains("corner 1 of the region");
  }

  @Test
  void refusesRegionsThatTheRobotsCannotReachOrLanesThatDoNotFit() {
    assertThat(refusedRegion("57,11 57.0002,11 57.0002,11.0004"))
        .contains(" km from the robot at ", "farther than 2000.0 m");
    assertThat(
            refused(
                ExitCode.FAILED,
                ("raster|--local|--swath|20|--spacing|12|--region|" + SQUARE).split("\\|")))
        .startsWith("dfra: lanes 12.00 m apart are wider than the region, which is 8.9")
        .endsWith(" m from west to east; give a smaller --spacing or a larger --region");
  }

  @Test
  void refusesFilesThatAreNotThereOrAreSomethingElse() throws IOException {
    assertThat(refusedRegion("nowhere.geojson"))
        .startsWith("dfra: nowhere.geojson: there is no such file");
    assertThat(refused(ExitCode.FAILED, "raster", "--local", "--world", "nowhere.xml"))
        .startsWith("dfra: nowhere.xml: there is no such file");
    Path point = folder.resolve("point.json");
    Files.writeString(point, "{\"type\": \"Point\", \"coordinates\": [11, 48]}");
    assertThat(refusedRegion(point.toString())).contains("it contains no polygon");
  }

  @Test
  void refusesWorldsThatNobodyCanSearch() throws IOException {
    assertThat(refused(ExitCode.USAGE_ERROR, "raster", "--local", "--world", world("")))
        .isEqualTo("dfra: the world small has no region; add one, or give --region");
    assertThat(
            refused(
                ExitCode.USAGE_ERROR,
                "raster",
                "--local",
                "--region",
                SQUARE,
                "--world",
                world("")))
        .isEqualTo("dfra: the world small has no robots; add atrv1 and atrv2");
    String rover = "<robot name=\"rover\" type=\"ugv\" east=\"3\" north=\"3\"/>";
    assertThat(
            refused(
                ExitCode.USAGE_ERROR,
                ("raster|--local|--region|" + SQUARE + "|--world|" + world(rover)).split("\\|")))
        .contains("the robot rover cannot search: there is no ", "rover.xml");
  }

  private String world(String things) throws IOException {
    Path file = folder.resolve("world.xml");
    Files.writeString(
        file,
        "<world xmlns=\"urn:dfra:world:1\" name=\"small\">"
            + "<datum latitude=\"48\" longitude=\"11\" height=\"520\"/>"
            + "<ground size_east=\"40\" size_north=\"30\"/>"
            + things
            + "</world>");
    return file.toString();
  }

  @Test
  void refusesOptionsOfTheRasterForOtherDemonstrations() {
    assertThat(refused(ExitCode.USAGE_ERROR, "persona", "--local"))
        .isEqualTo(
            "dfra: --local is an option of the demonstration raster; persona does not have it; see: ./dfra"
                + " demo --help");
    assertThat(refused(ExitCode.USAGE_ERROR, "devices", "--swath", "2"))
        .contains("--swath is an option of the demonstration raster");
    assertThat(refused(ExitCode.USAGE_ERROR, "nosuch"))
        .contains("there is no demonstration \"nosuch\"; there is raster, recruit, devices");
  }
}
