package org.dfra.example.patrol;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.PathGoal;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.RobotXml;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.robot.LocalRobot;
import org.dfra.core.state.StateStore;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.sim.run.Simulation;
import org.dfra.sim.time.LockStep;
import org.dfra.sim.world.file.WorldXml;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A simulated robot with its real drivers goes on patrol: minutes of its time in seconds. */
@Timeout(120)
class PatrolTest {

  private static final Path CONFIG = Path.of(System.getProperty("dfra.root"), "config");
  private static final LocalFrame FIELD = new LocalFrame(new GeoPosition(48, 11, 520));
  private static final Duration LONG = Duration.ofMinutes(5);

  @Test
  void goesRoundPausesAndComesToItsEnd() throws Exception {
    LockStep time = new LockStep(Instant.parse("2026-11-21T12:00:00Z"));
    try (Simulation field =
            Simulation.inLockStep(WorldXml.read(CONFIG.resolve("worlds/raster.xml")), time);
        InMemoryModuleDirectory directory = new InMemoryModuleDirectory(time)) {
      field.start();
      Map<String, String> links = new HashMap<>();
      field.endpoints().forEach(line -> links.put(line.linkVariable(), line.link()));
      try (LocalRobot robot =
              new LocalRobot(
                  RobotXml.read(CONFIG.resolve("teams/raster/atrv1.xml"), links::get),
                  directory,
                  time,
                  module -> StateStore.inMemory());
          PatrolImpl patrol =
              new PatrolImpl(
                  new ModuleContext(
                          "atrv1",
                          "patrol",
                          Parameters.of("atrv1/patrol", Map.of("rounds", "2")),
                          time,
                          StateStore.inMemory())
                      .withDirectory(directory))) {
        robot.start();
        patrol.start();
        directory.add(patrol);
        time.advance(Duration.ofSeconds(30)); // the receivers find their satellites

        UUID goal = patrol.pursue(new PathGoal(null, List.of(at(8, 4), at(4, 5)), 1));
        assertThat(
                time.advanceUntil(() -> patrol.status().activity().startsWith("leg 3 of 4"), LONG))
            .as("%s", patrol.status())
            .isTrue();
        patrol.pause();
        time.advance(Duration.ofSeconds(5));
        assertThat(patrol.status().phase()).isEqualTo(Phase.PAUSED);
        patrol.resume();
        assertThat(time.advanceUntil(() -> patrol.status().phase() == Phase.SUCCEEDED, LONG))
            .as("%s", patrol.status())
            .isTrue();
        assertThat(patrol.status().goal()).isEqualTo(goal);
        assertThat(patrol.status().activity()).isEqualTo("the patrol is over");
      }
    }
  }

  private static GeoPosition at(double east, double north) {
    return FIELD.toGeo(new LocalPosition(east, north, 0));
  }
}
