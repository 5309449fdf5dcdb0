package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import org.dfra.app.MarkedProcesses.Outcome;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotDescription.GroupDescription;
import org.dfra.core.config.RobotXml;
import org.dfra.core.host.FreePorts;
import org.dfra.sim.run.Simulation;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;
import org.dfra.sim.world.file.WorldXml;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * {@code ./dfra task} with the two robots of the raster world, whose modules run as on a real one,
 * though each robot's in one process.
 */
@Timeout(360)
class TaskVerbsIT {

  private static final Duration PATIENCE = Duration.ofSeconds(90);
  private static final Path CONFIG = Path.of(System.getProperty("dfra.root"), "config");

  /** A field of 9 m by 8 m in the middle of the world, between the robots. */
  private static final String NEAR =
      "48.000103,11.000215 48.000103,11.000335 48.000175,11.000335 48.000175,11.000215";

  /** The same 1000 km farther north. */
  private static final String FAR =
      "57.000103,11.000215 57.000103,11.000335 57.000175,11.000335 57.000175,11.000215";

  /** Where something is missing it is used up; where nothing is, a busy computer may need it. */
  private static final String WAIT = "--wait=20";

  @TempDir static Path folder;

  private static Simulation world;
  private static MarkedProcesses processes;

  @BeforeAll
  static void bringUp() throws Exception {
    processes = new MarkedProcesses(folder);
    world =
        Simulation.overTcp(
            WorldXml.read(CONFIG.resolve("worlds/raster.xml"), name -> null),
            InstantSource.system(),
            Simulation.PortPolicy.EPHEMERAL);
    world.start();
    Outcome up =
        processes.dfra(
            PATIENCE,
            "up",
            robot("atrv1"),
            robot("atrv2"),
            "--port=" + FreePorts.allocate(),
            "--registry-port=-1",
            state());
    assertThat(up.exit()).as(up.out() + up.err()).isZero();
    await().atMost(PATIENCE).until(() -> !output("module", "list").contains("initializing"));
  }

  /** The robot's own description with its registrar and all modules in one group. */
  private static String robot(String name) throws Exception {
    Map<String, String> settings = new HashMap<>();
    settings.put("DFRA_HOST", "127.0.0.1");
    settings.put("DFRA_" + name.toUpperCase(Locale.ROOT) + "_CLASS_PORT", "off");
    settings.put(
        "DFRA_" + name.toUpperCase(Locale.ROOT) + "_REGISTRAR_PORT",
        Integer.toString(FreePorts.allocate()));
    world.endpoints().forEach(line -> settings.put(line.linkVariable(), line.link()));
    RobotDescription read =
        RobotXml.read(CONFIG.resolve("teams/raster/" + name + ".xml"), settings::get);
    List<ModuleDescription> modules = new ArrayList<>(read.modules());
    GroupDescription all =
        new GroupDescription(
            "all", List.of("-Xmx256m"), read.registrar(), modules, read.groups().get(0).place());
    Path xml = folder.resolve(name + ".xml");
    RobotXml.write(
        new RobotDescription(
            read.name(),
            read.host(),
            read.lookupGroups(),
            read.locators(),
            read.persona(),
            List.of(all),
            xml),
        xml);
    return xml.toString();
  }

  @AfterAll
  static void takeDown() throws Exception {
    try {
      Outcome down = MarkedProcesses.here("down", state());
      assertThat(down.exit()).as(down.out() + down.err()).isZero();
    } finally {
      processes.close();
      if (world != null) {
        world.close();
      }
    }
  }

  private static String state() {
    return "--state=" + folder.resolve("state");
  }

  private static Outcome ask(String... words) {
    boolean hasWait = Arrays.stream(words).anyMatch(each -> each.startsWith("--wait="));
    Stream<String> usual = Stream.of("--team=", "--locator=", "--host=127.0.0.1", state());
    return MarkedProcesses.here(
        Stream.of(Arrays.stream(words), usual, Stream.of(WAIT).filter(each -> !hasWait))
            .flatMap(each -> each)
            .toArray(String[]::new));
  }

  private static String output(String... words) {
    Outcome outcome = ask(words);
    assertThat(outcome.exit()).as(outcome.out() + outcome.err()).isZero();
    return outcome.out();
  }

  private static void refused(int exit, String sentence, String... words) {
    Outcome outcome = ask(words);
    assertThat(outcome.exit()).as(outcome.out() + outcome.err()).isEqualTo(exit);
    assertThat(outcome.err().lines()).as(outcome.err()).hasSize(1);
    assertThat(outcome.err()).startsWith("dfra: ").contains(sentence);
    assertThat(outcome.out()).isEmpty();
  }

  private static JsonNode tasks(String... words) throws Exception {
    return new ObjectMapper()
        .readTree(
            output(
                Stream.concat(Stream.of("task"), Stream.concat(Arrays.stream(words), json()))
                    .toArray(String[]::new)));
  }

  private static Stream<String> json() {
    return Stream.of("--json");
  }

  /** Whether a robot's wheels turn. */
  private static boolean moves(String robot) {
    GroundTruthPose pose = world.world().groundTruth().pose(robot, Instant.now());
    return pose.speed() > 0.05 || Math.abs(pose.yawRate()) > 0.05;
  }

  private static void assertPhases(JsonNode tasks, String first, String second) {
    assertThat(List.of(tasks.get(0).get("robot").asText(), tasks.get(1).get("robot").asText()))
        .containsExactly("atrv1", "atrv2");
    assertThat(phases(tasks)).as(tasks.toString()).containsExactly(first, second);
  }

  private static List<String> phases(JsonNode tasks) {
    return List.of(tasks.get(0).get("phase").asText(), tasks.get(1).get("phase").asText());
  }

  private static void awaitMotion() {
    await().atMost(PATIENCE).until(() -> moves("atrv1") && moves("atrv2"));
  }

  private static void awaitRest() {
    await().atMost(PATIENCE).until(() -> !moves("atrv1") && !moves("atrv2"));
  }

  @Test
  void robotsAreSentPausedSentOnAndCalledOff() throws Exception {
    List<String> before = phases(tasks("status"));
    assertThat(before).as("none that runs").isSubsetOf("IDLE", "CANCELLED");
    assertThat(phases(tasks("pause"))).isEqualTo(before);

    Outcome sent = ask("task", "submit", "raster", "--region=" + NEAR);
    assertThat(sent.exit()).as(sent.out() + sent.err()).isZero();
    assertThat(sent.err()).contains("how far they are: ./dfra task status");
    assertThat(sent.out().lines().map(line -> line.replaceAll(" +", " ")))
        .filteredOn(line -> !line.startsWith(" ")) // what a robot is at may need two lines
        .satisfiesExactly(
            line -> assertThat(line).isEqualTo("ROBOT STATE DONE ACTIVITY"),
            line -> assertThat(line).startsWith("atrv1 running 0 % "),
            line -> assertThat(line).startsWith("atrv2 running 0 % "));
    awaitMotion();
    refused(
        1,
        "atrv1/raster_search pursues another goal (",
        "task",
        "submit",
        "raster",
        "--region=" + NEAR);
    assertThat(moves("atrv1") || moves("atrv2")).as("after a refusal").isTrue();

    assertPhases(tasks("pause"), "PAUSED", "PAUSED");
    awaitRest();
    assertThat(tasks("resume", "--robot=atrv2")).hasSize(1);
    await().atMost(PATIENCE).until(() -> moves("atrv2"));
    assertThat(moves("atrv1")).isFalse();
    assertPhases(tasks("status"), "PAUSED", "RUNNING");

    assertThat(output("stop", "--all")).contains("atrv1/drive: stopped.", "atrv2/drive: stopped.");
    awaitRest();
    await().atMost(PATIENCE).untilAsserted(() -> assertPhases(tasks("status"), "PAUSED", "PAUSED"));
    assertThat(output("stop", "--release", "--all")).contains("2 effectors: 2 released.");
    assertPhases(tasks("status"), "PAUSED", "PAUSED");
    assertPhases(tasks("resume"), "RUNNING", "RUNNING");
    awaitMotion();
    assertPhases(tasks("cancel"), "CANCELLED", "CANCELLED");
    awaitRest();
    assertPhases(tasks("resume"), "CANCELLED", "CANCELLED");
  }

  @Test
  void refusesBeforeAnyRobotMoves() throws Exception {
    List<String> before = phases(tasks("status"));
    awaitRest();
    refused(
        3,
        "robot atrv3 has no RasterSearch, or is not there; ./dfra persona list",
        "task",
        "status",
        "--robot=atrv3",
        "--wait=6");
    refused(
        3,
        "robot atrv3 has no RasterSearch",
        "task",
        "submit",
        "raster",
        "--region=" + NEAR,
        "--robot=atrv1,atrv3",
        "--wait=6");
    refused(2, "--robot names no robot", "task", "cancel", "--robot=,");
    await() // until they know where they are
        .atMost(PATIENCE)
        .until(() -> ask("module", "call", "atrv2/position", "estimate").exit() == 0);
    refused(1, " km from the robot at ", "task", "submit", "raster", "--region=" + FAR);
    Path file = folder.resolve("far.geojson");
    Files.writeString(
        file,
        """
        {"type": "Polygon", "coordinates": [[
          [11.000215, 57.000103], [11.000335, 57.000103], [11.000335, 57.000175],
          [11.000215, 57.000103]]]}
        """);
    refused(1, " km from the robot at ", "task", "submit", "raster", "--region=" + file);
    assertThat(phases(tasks("status"))).isEqualTo(before).isSubsetOf("IDLE", "CANCELLED");

    JsonNode one = tasks("submit", "raster", "--region=" + NEAR, "--robot=atrv2");
    assertThat(one).hasSize(1);
    assertThat(one.get(0).get("module").asText()).isEqualTo("atrv2/raster_search");
    refused(
        1,
        "atrv2/raster_search pursues another goal (",
        "task",
        "submit",
        "raster",
        "--region=" + NEAR);
    assertPhases(tasks("status"), before.get(0), "RUNNING");
    assertThat(moves("atrv1")).as("where the other refused").isFalse();
    assertThat(tasks("cancel", "--robot=atrv2,atrv2")).hasSize(1);
    awaitRest();
  }
}
