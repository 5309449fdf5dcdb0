package org.dfra.secure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.dfra.secure.SecureTeam.ANNA;
import static org.dfra.secure.SecureTeam.ok;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.dfra.app.MarkedProcesses.Outcome;
import org.dfra.core.audit.HeadStore;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The end of a robot's audit trail is cut off, and another robot has kept its head. */
@Timeout(300)
class AuditHeadsIT {

  private static final String FIRST = "atrv1";
  private static final String SECOND = "atrv2";

  @TempDir private Path folder;

  @Test
  void aCutTrailIsNoticedByTheHeadsThatOthersKeep() throws Exception {
    try (SecureTeam team = new SecureTeam(folder)) {
      team.init();
      team.admit("robot", FIRST);
      team.admit("robot", SECOND);
      for (String robot : List.of(FIRST, SECOND)) {
        team.describe(
            robot, TeamRobots.group("all", TeamRobots.registrar(), TeamRobots.thermometer(17)));
        ok(team.up(robot));
      }
      await()
          .atMost(SecureTeam.PATIENCE)
          .until(() -> files(team.state(FIRST).resolve("heads/own")).size() >= 2);
      Path kept = team.state(SECOND).resolve("heads/kept.jsonl");
      await() // a command may end before both have answered
          .pollInSameThread()
          .atMost(SecureTeam.PATIENCE)
          .until(
              () -> {
                ok(team.ask(FIRST, "module", "call", "atrv2/warmth", "celsius"));
                return keeps(kept, "robot atrv1 of field")
                    && keeps(team.state(FIRST).resolve("heads/kept.jsonl"), "robot atrv2 of field");
              });
      Path operators = team.state(ANNA).resolve("heads/kept.jsonl");
      await()
          .pollInSameThread()
          .atMost(SecureTeam.PATIENCE)
          .until(
              () -> {
                ok(team.ask(ANNA, "module", "list"));
                return keeps(operators, "robot atrv1 of field");
              });

      Outcome whole = ok(team.ask(FIRST, "audit", "verify", "--from=" + SECOND));
      assertThat(whole.out()).contains("are whole").doesNotContain("would not be missed");
      ok(team.dfra(FIRST, "down"));
      String stream =
          HeadStore.read(kept).stream()
              .filter(each -> each.member().toString().equals("robot atrv1 of field"))
              .max(Comparator.comparing(each -> each.head().number()))
              .orElseThrow()
              .head()
              .stream();
      Path trail = team.state(FIRST).resolve("audit/" + stream + ".000001.jsonl");
      Files.write(trail, Files.readAllLines(trail).subList(0, 2));
      assertThat(team.dfra(FIRST, "audit", "verify").out())
          .contains("Lines that were cut off at the end would not be missed")
          .doesNotContain("BROKEN");
      Outcome cut = team.ask(FIRST, "audit", "verify", "--from=" + SECOND);
      assertThat(cut.exit()).as(cut.out() + cut.err()).isEqualTo(1);
      assertThat(cut.out())
          .contains(
              stream
                  + " is BROKEN at "
                  + trail
                  + ":2: the stream was cut after line 2: robot atrv1 of field signed number ");
      Outcome copy = team.dfra(ANNA, "audit", "verify", "--trail=" + trail.getParent());
      assertThat(copy.exit()).as("by the heads that the operator keeps").isEqualTo(1);
      assertThat(copy.out()).contains(trail + ":2: the stream was cut after line 2");
      Outcome nobody = team.ask(FIRST, "audit", "verify", "--from=atrv3", "--wait=1");
      assertThat(nobody.err()).contains("robot atrv3 has no module that answers");
    }
  }

  private static List<Path> files(Path in) throws IOException {
    if (!Files.isDirectory(in)) {
      return List.of();
    }
    try (Stream<Path> files = Files.list(in)) {
      return files.filter(each -> each.toString().endsWith(".jsonl")).toList();
    }
  }

  private static boolean keeps(Path file, String member) throws IOException {
    return Files.exists(file)
        && HeadStore.read(file).stream().anyMatch(each -> each.member().toString().equals(member));
  }
}
