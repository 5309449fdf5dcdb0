package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.dfra.app.MarkedProcesses.Outcome;
import org.dfra.app.terminal.ExitCode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The demonstrations, run as a user runs them. */
class DemoIT {

  private static final Duration PATIENCE = Duration.ofSeconds(120);

  /** What a terminal is wide, with some room for the figures that are missed. */
  private static final int WIDTH = 110;

  @TempDir Path folder;

  @Test
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
  void thePersonaTellsItsStoryAndLeavesNothingBehind() throws Exception {
    play(
        "persona",
        "Two robots come up",
        "Robot atrv1 is up after",
        "Robot atrv2 is up after",
        "A client meets them",
        "Robot atrv1, scout: fresh goals Search the north field",
        "limitations It drives on firm ground",
        "gps_front ready GPSSensor 1.0 2D/3D fix, up to 1 Hz 27.950603° N, 82.457200° W",
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
        "call to a killed receiver answered by the other",
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

  /** Runs a demonstration and looks at what it says, records, answers and leaves behind. */
  private void play(String name, String... story) throws Exception {
    Path temp = Files.createDirectory(folder.resolve("tmp"));
    Path csv = folder.resolve("figures.csv");
    try (MarkedProcesses processes = new MarkedProcesses(folder, "-Djava.io.tmpdir=" + temp)) {
      Outcome outcome = processes.dfra(PATIENCE, "demo", name, "--record=" + csv);

      assertThat(outcome.out() + outcome.err()).doesNotContain("FAILED");
      assertThat(outcome.err()).isEmpty();
      assertThat(outcome.out().replaceAll("\\s+", " ")).as("the story").containsSubsequence(story);
      assertThat(outcome.out().lines()).allMatch(line -> line.length() <= WIDTH);
      long figures = outcome.out().lines().filter(line -> line.contains("wanted ≤")).count();
      assertThat(Files.readAllLines(csv)).as("a header and a row each").hasSize((int) figures + 1);
      // A machine that is busy with other work may miss a figure; then it has to say so.
      int expected = outcome.out().contains("MISSED") ? ExitCode.FAILED : ExitCode.WELL;
      assertThat(outcome.exit()).as(outcome.out()).isEqualTo(expected);
      assertThat(processes.living()).as("processes left").isEmpty();
    }
    try (var left = Files.list(temp)) {
      assertThat(left.toList()).as("left in the temporary folder").isEqualTo(List.of());
    }
  }
}
