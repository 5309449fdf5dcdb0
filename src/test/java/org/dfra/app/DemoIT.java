package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.dfra.app.MarkedProcesses.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The demonstrations, run as a user runs them. */
class DemoIT {

  private static final Duration PATIENCE = Duration.ofSeconds(120);

  @TempDir Path folder;

  @Test
  void theFoundationTellsItsStoryAndLeavesNothingBehind() throws Exception {
    Path temp = Files.createDirectory(folder.resolve("tmp"));
    Path figures = folder.resolve("figures.csv");
    try (MarkedProcesses processes = new MarkedProcesses(folder, "-Djava.io.tmpdir=" + temp)) {
      Outcome outcome = processes.dfra(PATIENCE, "demo", "foundation", "--record=" + figures);

      assertThat(outcome.exit()).as(outcome.out() + outcome.err()).isZero();
      assertThat(outcome.err()).isEmpty();
      assertThat(outcome.out().replaceAll("\\s+", " "))
          .as("the story")
          .containsSubsequence(
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
      assertThat(Files.readAllLines(figures)).as("a header and six figures").hasSize(7);
      assertThat(processes.living()).as("processes left").isEmpty();
    }
    try (var left = Files.list(temp)) {
      assertThat(left.toList()).as("left in the temporary folder").isEqualTo(List.of());
    }
  }
}
