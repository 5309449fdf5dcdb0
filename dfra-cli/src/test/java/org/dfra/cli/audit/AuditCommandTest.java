package org.dfra.cli.audit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dfra.cli.Main;
import org.dfra.core.audit.AuditEvent;
import org.dfra.core.audit.AuditSettings;
import org.dfra.core.audit.AuditTrail;
import org.dfra.security.AccessRequest;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Decision;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** What {@code ./dfra audit} prints. */
class AuditCommandTest {

  private static final Duration PATIENCE = Duration.ofSeconds(10);

  private static final Caller ANNA =
      new Caller(
          Standing.MEMBER,
          Optional.of(new Member("field", MemberRole.OPERATOR, "anna")),
          "192.0.2.7");

  /** What is called. */
  interface Drive {
    void setVelocity(double metresPerSecond);
  }

  @TempDir Path state;

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int run(String... words) {
    List<String> all = new ArrayList<>(List.of("audit"));
    all.addAll(List.of(words));
    all.add("--state=" + state);
    String[] args = all.toArray(String[]::new);
    out.getBuffer().setLength(0);
    err.getBuffer().setLength(0);
    CommandLine line = Main.commandLine(args);
    line.setOut(new PrintWriter(out, true));
    line.setErr(new PrintWriter(err, true));
    return line.execute(args);
  }

  private AuditTrail started(String stream, Instant time) throws Exception {
    AuditSettings settings =
        AuditSettings.of(AuditSettings.folder(state), stream, "robot atrv1 of field");
    AuditTrail trail = new AuditTrail(settings, InstantSource.fixed(time));
    trail.start();
    return trail;
  }

  private static AuditEvent call(Caller caller, String robot, boolean isPermitted)
      throws Exception {
    AccessRequest request =
        new AccessRequest(
            caller, robot, "drive", Drive.class.getMethod("setVelocity", double.class));
    return AuditEvent.call(
        request,
        isPermitted
            ? Decision.permit("operators")
            : Decision.deny("default", "strangers may not drive"),
        List.of());
  }

  /** Two streams; the second begins before the first. */
  private void write(Instant time) throws Exception {
    try (AuditTrail trail = started("wheels", time)) {
      trail.record(call(ANNA, "atrv1", true));
    }
    try (AuditTrail trail = started("gps", time.minusSeconds(5))) {
      trail.record(call(Caller.stranger("198.51.100.9"), "atrv2", false));
    }
  }

  @Test
  void anAbsentAndAnEmptyTrailAreASentence() throws Exception {
    for (String[] words : List.of(new String[] {}, new String[] {"show"})) {
      assertThat(run(words)).isZero();
      assertThat(out.toString().replaceAll("\\s+", " ")).startsWith("There is no audit trail in ");
    }
    assertThat(run("--follow")).isZero();
    Files.createDirectory(AuditSettings.folder(state));
    assertThat(run()).isZero();
    assertThat(out.toString().replaceAll("\\s+", " ")).endsWith("has no such record. ");
    assertThat(run("--json")).isZero();
    assertThat(new ObjectMapper().readTree(out.toString()).isArray()).isTrue();
    assertThat(run("verify")).isEqualTo(3);
    assertThat(err.toString()).contains("there is no audit trail in");
  }

  @Test
  void recordsOfAllStreamsAreMergedByTime() throws Exception {
    write(Instant.parse("2026-11-28T21:00:00Z"));
    assertThat(run("--json")).isZero();
    JsonNode records = new ObjectMapper().readTree(out.toString());
    assertThat(records.findValuesAsText("time")).isSorted();
    assertThat(records.findValuesAsText("stream"))
        .containsExactly("gps", "gps", "wheels", "wheels");
    assertThat(records.get(0).path("decision").asText()).isEqualTo("deny");
    assertThat(run("show")).isZero();
    assertThat(out.toString())
        .contains("2026-11-28T20:59:55.000Z", "a stranger", "strangers may not drive")
        .contains("operator anna of field", "atrv1/drive", "Drive.setVelocity");
  }

  @Test
  void filtersByCallerDecisionRobotAndTime() throws Exception {
    write(Instant.now());
    assertThat(records("--who=anna")).isEqualTo(1);
    assertThat(records("--who=198.51.100.9")).isEqualTo(1);
    assertThat(records("--who=bob")).isZero();
    assertThat(records("--denied")).isEqualTo(1);
    assertThat(records("--robot=atrv1")).isEqualTo(1);
    assertThat(records("--robot=atrv1", "--denied")).isZero();
    assertThat(records("--since=10m")).isEqualTo(4);
    assertThat(records("--last=3")).isEqualTo(3);
    assertThat(records("--last=0")).isEqualTo(4);
    try (AuditTrail old = started("old", Instant.now().minusSeconds(7200))) {
      old.record(call(ANNA, "atrv1", true));
    }
    assertThat(records("--since=1h")).isEqualTo(4);
    assertThat(run("--since=soon")).isEqualTo(2);
    assertThat(err.toString()).contains("--since=soon is not a time such as");
    assertThat(run("--last=-1")).isEqualTo(2);
  }

  private int records(String... words) throws Exception {
    List<String> all = new ArrayList<>(List.of(words));
    all.add("--json");
    assertThat(run(all.toArray(String[]::new))).isZero();
    return new ObjectMapper().readTree(out.toString()).size();
  }

  @Test
  void verificationNamesTheBrokenLineAndFails() throws Exception {
    write(Instant.parse("2026-11-28T21:00:00Z"));
    assertThat(run("verify")).isZero();
    assertThat(out.toString()).contains("gps: lines 1 to 3 are whole, in 1 file");
    Path file = AuditSettings.folder(state).resolve("gps.000001.jsonl");
    Files.writeString(file, Files.readString(file).replace("\"deny\"", "\"permit\""));
    assertThat(run("verify")).isEqualTo(1);
    assertThat(out.toString().replaceAll("\\s+", ""))
        .contains("gpsisBROKENat" + file + ":2:thislineorthenextonewaschanged");
    assertThat(run("verify", "--json")).isEqualTo(1);
    JsonNode streams = new ObjectMapper().readTree(out.toString());
    assertThat(streams.get(0).path("line").asInt()).isEqualTo(2);
    assertThat(streams.get(0).path("kind").asText()).isEqualTo("CHANGED");
    assertThat(streams.get(1).path("isWhole").asBoolean()).isTrue();
    assertThat(run("verify", "--head=" + state.resolve("none"))).isEqualTo(1);
    assertThat(err.toString().replaceAll("\\s+", " ")).contains("there is no file");
  }

  @Test
  void followedTrailShowsWhatIsWrittenUntilItIsInterrupted() throws Exception {
    write(Instant.parse("2026-11-28T21:00:00Z"));
    Thread follower = new Thread(() -> run("--follow"));
    follower.start();
    await().atMost(PATIENCE).until(() -> out.toString().lines().count() >= 4);
    try (AuditTrail trail = started("gps", Instant.parse("2026-11-28T21:01:00Z"))) {
      trail.record(call(ANNA, "atrv3", false));
      trail.flush(PATIENCE);
      await().atMost(PATIENCE).until(() -> out.toString().contains("atrv3/drive"));
    }
    follower.interrupt();
    follower.join(PATIENCE.toMillis());
    assertThat(follower.isAlive()).isFalse();
    assertThat(out.toString().lines())
        .isNotEmpty()
        .allSatisfy(each -> assertThat(each).isNotBlank());
  }
}
