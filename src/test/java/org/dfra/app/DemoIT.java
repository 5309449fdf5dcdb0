package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dfra.app.MarkedProcesses.Outcome;
import org.dfra.app.terminal.ExitCode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

/**
 * The demonstrations, run as a user runs them. In the everyday tier those that take a minute; what
 * the others show on the way, the tests of {@code org.dfra.phoenix} and {@code
 * org.dfra.slice.RecruitmentAgentsIT} try one by one.
 */
class DemoIT {

  private static final Duration PATIENCE = Duration.ofSeconds(900);

  /** Sentences; tables are narrower. */
  private static final int WIDTH = 96;

  /** Tables, where there is no terminal. */
  private static final int TABLE = 80;

  @TempDir Path folder;

  @Test
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "takes minutes")
  void theFoundationTellsItsStoryAndLeavesNothingBehind() throws Exception {
    play(
        "foundation",
        "A robot comes up",
        "Phoenix, the activation daemon, is process",
        "Robot atrv1 is up",
        "A client finds a receiver",
        "found atrv1/gps_front (GPSProxy) through discovery and lookup",
        "27.950600° N, 82.457200° W",
        "kill -9 of the receiver's virtual machine",
        "The same proxy answered again after",
        "kill -STOP",
        "got no answer within 2000 ms",
        "Activation itself",
        "kill -9 of phoenix",
        "The receiver answered on",
        "registrations are there, and the living groups were taken back, not doubled",
        "The adopted group was killed too",
        "The proxy in the module's own virtual machine",
        "All is shut down: none of the",
        "Measured",
        "cold start of everything to position read",
        "GPS group killed to same proxy answering",
        "silent server reported",
        "activation of an object in a live group",
        "phoenix restart to ready, 1000 objects",
        "same-VM proxy call over the direct call");
  }

  @Test
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "takes minutes")
  void recruitmentTellsItsStoryAndLeavesNothingBehind() throws Exception {
    play(
        "recruit",
        "The team",
        "appears: its agent can observe mine",
        "nobody in reach of uav can observe \"gold\"; others observe mine",
        "One comes, observes, and is released",
        "uav calls for somebody who can observe \"mine\", 12 m east and 11 m north",
        "observes for 8 s of the robots' time",
        "uav has seen enough and releases",
        "One dies on its way, and is replaced",
        "Phoenix brings the agent back, which finds no robot to drive",
        "The requester cannot be reached any more",
        "has freed itself, with nobody to tell it so",
        "which was called away from its search and went on with it, has searched",
        "letters were sent",
        "All is shut down: none of the",
        "Measured",
        "death to another on its way",
        "robots that are still bound to somebody",
        "seconds in which two helped at once",
        "recruited robots that had not been searching",
        "searches that were left and did not go on");
  }

  @Test
  void thePersonaTellsItsStoryAndLeavesNothingBehind() throws Exception {
    play(
        "persona",
        "Two robots come up",
        "Robot atrv1 is up after",
        "Robot atrv2 is up after",
        "A client meets them",
        "Robot atrv1, scout: fresh goals Search the north field",
        "limitations It drives on firm ground",
        "gps_front ready GPSSensor 1.0 2D/3D fix,",
        "gps_rear ready GPSSensor 1.0",
        "Robot atrv2, carrier: fresh goals",
        "It asks by what is needed, not by name",
        "with a 3-D fix, at 1 Hz or more\": 4 answers",
        "atrv2/gps_rear 27.950797° N, 82.457000° W",
        "It listens to all four",
        "Reading no.",
        "kill -9 of a receiver's process, while a client listens",
        "The client did nothing for either.",
        "so a gap is seen and counted",
        "kill -9 under a call",
        "atrv1/gps_front answered first.",
        "the call was answered by atrv1/gps_rear; the caller saw no failure",
        "kill -STOP: a process falls silent",
        "the client's subscription to it reported that it is interrupted",
        "atrv2/gps_front (stopped) 0 - - -",
        "let go on (kill -CONT)",
        "A robot's registrar is gone for a while",
        "Robot atrv1, scout: STALE, last vouched for",
        "atrv1/gps_front answered a call after",
        "Robot atrv1, scout: fresh",
        "The robot is changed while it works",
        "gps_roof ready GPSSensor 1.0",
        "gps_roof ready GPSSensor 1.1",
        "It was removed, and gone from the robot's persona",
        "0 were lost",
        "All is shut down: none of the",
        "Measured",
        "cold start of both robots to all modules working and shown",
        "a question by capability, answered from the client's cache",
        "receiver killed to its readings coming again",
        "receiver killed to the client's lease counted",
        "readings missed in the gap but not counted 0",
        "call to a killed receiver answered",
        "silent receiver reported",
        "longest wait for a reading while another receiver is silent",
        "registrar dead to its robot shown as stale",
        "phoenix started again to the robot fresh",
        "module added to it working and shown",
        "module replaced to the newer one working and shown",
        "module removed to it gone",
        "readings lost while the robot was changed 0",
        "longest wait for a reading while the robot was changed");
  }

  @Test
  void theDevicesTellTheirStoryAndLeaveNothingBehindButAReport() throws Exception {
    play(
        "devices",
        "A world begins, and a robot comes up in it",
        "7 lines lead to devices of atrv1",
        "The robot is up after",
        "A client asks for what it needs",
        "a drive that goes at 0.5 m/s or faster atrv1/drive",
        "a camera for heat atrv1/thermal",
        "It drives a square, and loses its drive on the way",
        "was killed: the one that drives",
        "it took a new one, looked where it was, and finished the square",
        "It turns its head, and its cameras with it",
        "6 images are in the report",
        "What truly happened",
        "The wheels stood",
        "The report",
        "All is shut down: none of the",
        "Measured",
        "cold start to every device working and shown",
        "drive's last command to the robot standing");

    String html = Files.readString(folder.resolve("report/report.html"));
    assertThat(html).contains("Where it went", "drive killed", "<img src=\"data:image/png;base64,");
    try (var files = Files.list(folder.resolve("report"))) {
      assertThat(files.map(file -> file.getFileName().toString()))
          .contains("truth.csv", "atrv1-drive.csv", "atrv1-laser.csv", "atrv1-thermal.csv");
    }
    assertThat(Files.readAllLines(folder.resolve("report/atrv1-odometry.csv")))
        .as("readings of the odometry")
        .hasSizeGreaterThan(100);
  }

  /** Four lanes of 7.5 m in the west of the field. */
  private static final String LANES =
      "48.000022,11.000154 48.000022,11.000248 48.000090,11.000248 48.000090,11.000154";

  /** A smaller region, without processes. */
  @Test
  void theRasterIsSearchedThoughLookupServicesEnd() throws Exception {
    String said =
        play(
            "raster",
            List.of("--embedded", "--speed=4", "--region=" + LANES),
            "A region becomes lanes",
            "lanes 1.75 m apart that makes 4 lanes",
            "Mode embedded: all robots run in one virtual machine",
            "The robots search it, each the other way round than the one before",
            "its registrar is ended, which listed its",
            "The search took",
            "atrv1: the region is searched: it has been everywhere.",
            "atrv2: the region is searched: it has been everywhere.",
            "How well they searched",
            "came to the end of its lanes yes yes",
            "collisions 0 0",
            "Measured",
            "registrar back to all modules listed again",
            "registrar back: modules that are listed under another service ID 0 wanted ≤ 0",
            "atrv2: lateness of 99 % of the control loop's last turns",
            "robots that did not come to the end of their lanes 0 wanted ≤ 0",
            "collisions 0 wanted ≤ 0",
            "share of the region that no robot saw");
    assertThat(said)
        .containsSubsequence(
            "atrv2: its registrar is ended", "atrv2: its registrar is back and lists its")
        .containsSubsequence("atrv1: its registrar is ended", "were without its registrar");
    assertReport("Mode embedded", "its registrar is ended");
  }

  /**
   * Minutes of processes that are killed, while the robots search the middle of the field: what a
   * user sees who says no more than {@code ./dfra demo}.
   */
  @Test
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "takes minutes")
  void theRasterIsSearchedThoughProcessesAreKilled() throws Exception {
    String said =
        play(
            "raster",
            List.of(),
            "A region becomes lanes",
            "6 lanes, 12 waypoints",
            "Mode processes: each robot has its phoenix",
            "The search took",
            "atrv1: the region is searched: it has been everywhere.",
            "atrv2: the region is searched: it has been everywhere.",
            "came to the end of its lanes yes yes",
            "collisions 0 0",
            "Measured",
            "robots that did not come to the end of their lanes 0 wanted ≤ 0",
            "collisions 0 wanted ≤ 0");
    assertThat(said)
        .containsSubsequence("atrv1: gps_front is killed", "atrv1: gps_front is back")
        .containsSubsequence(
            "atrv1: navigation is killed", "atrv1: its wheels stand", "atrv1: it goes on by itself")
        .containsSubsequence(
            "atrv1: drive is killed", "atrv1: its wheels stand", "atrv1: it goes on by itself")
        .containsSubsequence(
            "atrv2: its phoenix and its registrar are killed",
            "it drives on",
            "atrv2: phoenix is back")
        .contains(
            "gps_front killed to heard again",
            "navigation killed: last command to wheels standing (robot's time)",
            "navigation killed: waypoints to be driven to again 0 wanted ≤ 0",
            "drive killed: waypoints to be driven to again 0 wanted ≤ 0",
            "phoenix back: living groups that have another process 0 wanted ≤ 0");
    assertReport("Mode processes", "navigation is killed");
  }

  private void assertReport(String... contents) throws Exception {
    Path report = folder.resolve("report");
    assertThat(Files.readString(report.resolve("report.html")))
        .contains("Where they went", "What happened on the way", "<svg")
        .contains(contents);
    try (var files = Files.list(report)) {
      assertThat(files.map(file -> file.getFileName().toString()))
          .contains("paths.svg", "clearance.svg", "fuzzy.svg", "metrics.csv", "marks.csv")
          .contains("atrv1-path.csv", "atrv2-path.csv", "atrv1-advice.csv", "atrv2-fixes.csv");
    }
    for (String robot : List.of("atrv1", "atrv2")) {
      assertThat(Files.readAllLines(report.resolve(robot + "-path.csv")))
          .as("ten times a second")
          .hasSizeGreaterThan(300);
    }
    assertThat(Files.readAllLines(report.resolve("collisions.csv"))).as("a header").hasSize(1);
  }

  private void play(String name, String... story) throws Exception {
    String unused = play(name, List.of(), story);
  }

  /**
   * Runs a demonstration and looks at what it says, records, answers and leaves behind.
   *
   * @return what it said, in one line
   */
  private String play(String name, List<String> options, String... story) throws Exception {
    Path temp = Files.createDirectory(folder.resolve("tmp"));
    Path csv = folder.resolve("figures.csv");
    String said;
    try (MarkedProcesses processes = new MarkedProcesses(folder, "-Djava.io.tmpdir=" + temp)) {
      List<String> arguments =
          new ArrayList<>(List.of("demo", name, "--strict", "--record=" + csv));
      arguments.add("--report=" + folder.resolve("report"));
      arguments.addAll(options);
      Outcome outcome = processes.dfra(PATIENCE, arguments.toArray(String[]::new));
      said = outcome.out().replaceAll("\\s+", " ");

      assertThat(outcome.out() + outcome.err()).doesNotContain("FAILED");
      assertThat(outcome.err()).isEmpty();
      assertThat(said).as("the story").containsSubsequence(story);
      assertThat(outcome.out().lines().filter(line -> line.length() > WIDTH))
          .as("lines that are wider than %d columns", WIDTH)
          .isEmpty();
      List<String> figures =
          outcome
              .out()
              .lines()
              .dropWhile(line -> !line.equals("Measured"))
              .takeWhile(line -> !line.isEmpty())
              .toList();
      assertThat(figures.stream().filter(line -> line.length() > TABLE))
          .as("figures that are wider than %d columns", TABLE)
          .isEmpty();
      List<String> rows = Files.readAllLines(csv);
      assertThat(rows).as("a header and a row each").hasSizeGreaterThan(1);
      String measured = String.join(" ", figures).replaceAll("\\s+", " ");
      assertThat(rows.stream().skip(1).map(row -> row.split("\"", -1)[1]))
          .allMatch(figure -> measured.contains(figure));
      assertThat(outcome.out()).as("no colours in a pipe").doesNotContain("\u001b");
      // A machine that is busy with other work may miss a figure; then it has to say so.
      int expected = outcome.out().contains("MISSED") ? ExitCode.FAILED : ExitCode.WELL;
      assertThat(outcome.exit()).as(outcome.out()).isEqualTo(expected);
      assertThat(processes.living()).as("processes left").isEmpty();
    }
    try (var left = Files.list(temp)) {
      assertThat(left.toList()).as("left in the temporary folder").isEqualTo(List.of());
    }
    return said;
  }
}
