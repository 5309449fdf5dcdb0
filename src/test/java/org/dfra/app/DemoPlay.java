package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.fail;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dfra.app.MarkedProcesses.Outcome;
import org.dfra.app.terminal.ExitCode;
import org.junit.jupiter.api.io.TempDir;

/**
 * Runs a demonstration as a user runs it. In full its times are judged too, and nothing else runs
 * beside it; in the everyday tier it shares the computer, and only what must be true is judged.
 */
abstract class DemoPlay {

  private static final Duration PATIENCE = Duration.ofSeconds(900);

  /** Sentences; tables are narrower. */
  private static final int WIDTH = 96;

  /** Tables, where there is no terminal. */
  private static final int TABLE = 80;

  private static final boolean IS_STRICT = Boolean.getBoolean("dfra.full");

  /** How much of a story is shown before the place at which a sentence is missing. */
  private static final int CONTEXT = 300;

  @TempDir Path folder;

  final void play(String name, String... story) throws Exception {
    String unused = play(name, List.of(), story);
  }

  /**
   * Runs it and looks at what it says, records, answers and leaves behind.
   *
   * @return what it said, in one line
   */
  final String play(String name, List<String> options, String... story) throws Exception {
    Path temp = Files.createDirectory(folder.resolve("tmp"));
    Path csv = folder.resolve("figures.csv");
    String said;
    try (MarkedProcesses processes = new MarkedProcesses(folder, "-Djava.io.tmpdir=" + temp)) {
      List<String> arguments = new ArrayList<>(List.of("demo", name, "--record=" + csv));
      arguments.add("--report=" + folder.resolve("report"));
      if (IS_STRICT) {
        arguments.add("--strict");
      }
      arguments.addAll(options);
      Outcome outcome = processes.dfra(PATIENCE, arguments.toArray(String[]::new));
      said = outcome.out().replaceAll("\\s+", " ");

      assertThat(outcome.out() + outcome.err()).doesNotContain("FAILED");
      assertThat(outcome.err()).isEmpty();
      assertStory(said, story);
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
      boolean isMissed = IS_STRICT && outcome.out().contains("MISSED");
      int expected = isMissed ? ExitCode.FAILED : ExitCode.WELL;
      assertThat(outcome.exit()).as(outcome.out()).isEqualTo(expected);
      assertThat(processes.living()).as("processes left").isEmpty();
    }
    try (var left = Files.list(temp)) {
      assertThat(left.toList()).as("left in the temporary folder").isEqualTo(List.of());
    }
    return said;
  }

  /**
   * A sentence that comes out differently where the computer is too busy for the demonstration's
   * pace, though all is well: that the first of two receivers answers, or that nothing was lost.
   */
  static String atPace(String sentence) {
    return IS_STRICT ? sentence : "";
  }

  /** Says which sentence is missing and what stands in its place: the whole story has pages. */
  private static void assertStory(String said, String... story) {
    int from = 0;
    for (String sentence : story) {
      int found = said.indexOf(sentence, from);
      if (found < 0) {
        int known = Math.max(0, from - CONTEXT);
        fail(
            "the story does not say \"%s\" after \"…%s\"; it goes on: %s",
            sentence, said.substring(known, from), said.substring(from));
      }
      from = found + sentence.length();
    }
  }
}
