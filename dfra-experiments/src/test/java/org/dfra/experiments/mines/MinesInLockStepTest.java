package org.dfra.experiments.mines;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.Map;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.LegGoal;
import org.dfra.core.config.RobotXml;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.robot.LocalRobot;
import org.dfra.core.state.StateStore;
import org.dfra.flow.perceptual.MineDetector;
import org.dfra.flow.perceptual.MinePercept;
import org.dfra.flow.perceptual.MinePercept.Detection;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.persona.AttributeProvider;
import org.dfra.persona.PerceptualSchemaAttributes;
import org.dfra.sim.run.Simulation;
import org.dfra.sim.run.Simulation.DeviceEndpoint;
import org.dfra.sim.time.LockStep;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.description.WorldDescription.MineDescription;
import org.dfra.sim.world.file.WorldXml;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The robot of config/teams/mines drives past the mines of config/worlds/mines.xml. */
@Timeout(300)
class MinesInLockStepTest {

  private static final Path CONFIG = Path.of(System.getProperty("dfra.root"), "config");
  private static final Instant BEGIN = Instant.parse("2026-11-21T12:00:00Z");
  private static final Duration READY = Duration.ofMinutes(2);
  private static final Duration STANDING = Duration.ofSeconds(20); // its fixes get a mean
  private static final Duration DRIVE = Duration.ofMinutes(2);

  private static @Nullable MinePercept driven;

  @Test
  void aRobotFindsBothMinesThatItPassesAndNothingElse() throws Exception {
    WorldDescription world = world();
    MinePercept percept = drive();
    LocalFrame field = new LocalFrame(world.datum());
    for (MineDescription mine : world.mines()) {
      assertThat(percept.detections())
          .as("%s at %.1f, %.1f", mine.name(), mine.east(), mine.north())
          .anyMatch(each -> each.probability() > 0.8 && distance(field, each, mine) < 0.5);
    }
    assertThat(percept.detections())
        .as("what is no mine, but taken for one")
        .filteredOn(
            each -> world.mines().stream().noneMatch(mine -> distance(field, each, mine) < 0.5))
        .allMatch(each -> each.probability() <= 0.8);
  }

  @Test
  void theSameDriveShowsTheSame() throws Exception {
    assertThat(drivePast(world())).isEqualTo(drive());
  }

  private static WorldDescription world() {
    return WorldXml.read(CONFIG.resolve("worlds/mines.xml"), name -> null);
  }

  /** The drive that both tests ask about. */
  private static MinePercept drive() throws Exception {
    MinePercept known = driven;
    if (known == null) {
      known = drivePast(world());
      driven = known;
    }
    return known;
  }

  private static double distance(LocalFrame field, Detection sighting, MineDescription mine) {
    LocalPosition at = field.toLocal(sighting.position());
    return Math.hypot(at.east() - mine.east(), at.north() - mine.north());
  }

  private static MinePercept drivePast(WorldDescription world) throws Exception {
    LockStep time = new LockStep(BEGIN);
    try (Simulation simulation = Simulation.inLockStep(world, time);
        InMemoryModuleDirectory directory = new InMemoryModuleDirectory(time)) {
      simulation.start();
      Map<String, String> links = new HashMap<>();
      for (DeviceEndpoint line : simulation.endpoints()) {
        links.put(line.linkVariable(), line.link());
      }
      try (LocalRobot robot =
          new LocalRobot(
              RobotXml.read(CONFIG.resolve("teams/mines/atrv1.xml"), links::get),
              directory,
              time,
              path -> StateStore.inMemory())) {
        robot.start();
        for (ModuleImpl module : robot.modules()) {
          assertThat(time.advanceUntil(() -> module.readiness().serves(), READY))
              .as("%s is %s", module.identification().path(), module.readiness())
              .isTrue();
        }
        time.advance(STANDING);
        drive(robot, new LocalFrame(world.datum()), time);
        ModuleImpl detector = (ModuleImpl) robot.module("mine_detector", MineDetector.class).get();
        assertThat(detector.history().failures()).isZero();
        return ((MineDetector) detector).mines();
      }
    }
  }

  private static void drive(LocalRobot robot, LocalFrame field, LockStep time) throws Exception {
    GeoPosition from = field.toGeo(new LocalPosition(2, 6, 0));
    GeoPosition to = field.toGeo(new LocalPosition(15, 6, 0));
    GoToWaypoint driver = robot.module("go_to_waypoint", GoToWaypoint.class).get();
    var unused = driver.pursue(new LegGoal(from, to, 0.5));
    assertThat(
            time.advanceUntil(
                () -> {
                  try {
                    return !driver.status().phase().isUnderWay();
                  } catch (RemoteException e) {
                    throw new AssertionError(e);
                  }
                },
                DRIVE))
        .as("%s", driver.status())
        .isTrue();
    assertThat(driver.status().phase()).as("%s", driver.status()).isEqualTo(Phase.SUCCEEDED);
  }

  @Test
  void itsPersonaShowsTheMeasuredRates() throws Exception {
    LockStep time = new LockStep(BEGIN);
    try (InMemoryModuleDirectory directory = new InMemoryModuleDirectory(time);
        LocalRobot robot =
            new LocalRobot(
                RobotXml.read(CONFIG.resolve("teams/mines/atrv1.xml"), name -> null),
                directory,
                time,
                path -> StateStore.inMemory())) {
      ModuleImpl detector = (ModuleImpl) robot.module("mine_detector", MineDetector.class).get();
      Map<String, Double> recorded = RecordedRates.last();
      assertThat(((AttributeProvider) detector).attributes())
          .contains(
              new PerceptualSchemaAttributes(
                  "MinePercept",
                  "probability",
                  "bayes",
                  recorded.get("bayes_true_positive"),
                  recorded.get("bayes_false_positive")));
    }
  }
}
