package org.dfra.examples.mission.process;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.examples.mission.FewLanes;
import org.dfra.examples.mission.MissionProgressListener.MissionEvent;
import org.dfra.examples.mission.MissionResult;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.examples.mission.RecordingMissionListener;
import org.dfra.examples.mission.Scenario;
import org.dfra.examples.mission.SparseField;
import org.dfra.examples.mission.SparseField.Start;
import org.dfra.examples.mission.monitor.MissionMonitor.InjectedFault;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.measurement.RunMeasurements;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * One robot in real processes searches a few lanes while processes are killed. The short form does
 * so in a {@link SparseField}, beside whose lanes it starts, with one process for all devices. It
 * leaves to {@code dfra.full} the robot as it is shipped, among posts, its way to the lanes, and
 * the third lane.
 */
@Timeout(600)
class ProcessMissionIT {

  /** Robot's time; a search of this region takes some 70 s where nothing goes wrong. */
  private static final Duration LONGEST = Duration.ofMinutes(7);

  /** The last command of what commands the wheels to their standing. */
  private static final String STOP =
      "navigation killed: last command to wheels standing (robot's time)";

  private static final boolean FULL = Boolean.getBoolean("dfra.full");

  @TempDir Path folder;

  private final RecordingMissionListener reported = new RecordingMissionListener();
  private final RunMeasurements figures = new RunMeasurements();

  private MissionResult fly(List<InjectedFault<DemoRobot>> faults) throws Exception {
    Path world = FewLanes.WORLD;
    Scenario scenario = FewLanes.scenario();
    if (!FULL) {
      world = SparseField.world(folder, Map.of("atrv1", new Start(10.5, 3, 0)));
      Path robot = SparseField.robot(folder, "atrv1", "drive", Set.of("navigation", "lookup"));
      scenario = FewLanes.twoLanes(world, robot);
    }
    return new ProcessMission(scenario, world, 1, LONGEST, robot -> robot, faults, figures)
        .run(reported);
  }

  /**
   * The group that commands the wheels dies at full speed on a lane, and comes back; then every
   * registrar and phoenix die, and stay dead.
   */
  @Test
  void finishesItsLanesThoughItsNavigationDiesAndLaterEveryRegistrarAndPhoenix() throws Exception {
    InjectedFault<DemoRobot> navigation =
        new ProcessKillOnLane(0, "navigation", 0.1, true, InjectedFault.none());
    MissionResult flight =
        fly(List.of(navigation, new PhoenixOutage(0, 0.3, PhoenixOutage.NEVER, navigation)));

    RobotMissionResult robot = flight.robots().get(0);
    String steps = flight.events() + "; " + robot.ending() + "; " + figures.all();
    assertThat(robot.completed()).as(steps).isTrue();
    assertThat(flight.events()).as("as reported on the way").isEqualTo(reported.marks());
    assertThat(flight.events())
        .extracting(MissionEvent::what)
        .satisfiesExactly(
            what -> assertThat(what).startsWith("navigation is killed"),
            what -> assertThat(what).startsWith("its wheels have stopped"),
            what -> assertThat(what).startsWith("it continues by itself"),
            what -> assertThat(what).startsWith("its phoenix and its registrar are killed"));
    assertThat(figure(STOP).value()).as(steps).isBetween(0.05, 0.5);
    assertThat(figure("navigation killed: waypoints to be driven to again").value())
        .as(steps)
        .isZero();
    assertThat(robot.samples()).hasSizeGreaterThan(300);
    assertThat(robot.readings().advice()).isNotEmpty();
    assertThat(robot.readings().fixes())
        .extracting(fix -> fix.receiver())
        .contains("gps_front", "gps_rear");
  }

  private MeasuredValue figure(String what) {
    return figures.all().stream()
        .filter(each -> each.name().equals(what))
        .findFirst()
        .orElseThrow(() -> new AssertionError("there is no \"" + what + "\" in " + figures.all()));
  }
}
