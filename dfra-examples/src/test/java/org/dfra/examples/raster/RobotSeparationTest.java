package org.dfra.examples.raster;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.examples.mission.ModuleReadings;
import org.dfra.examples.mission.ModuleReadings.TeammateDistance;
import org.dfra.examples.mission.RobotLog.Sample;
import org.dfra.time.ClockOffset;
import org.junit.jupiter.api.Test;

/** The distance that a robot reported to another, compared with the true one. */
class RobotSeparationTest {

  private static final ClockOffset CLOCK =
      new ClockOffset(Duration.ofMillis(800), Duration.ofMillis(10));

  /** From east 0 on at so many metres per second, sampled every 0.1 s up to 10 s. */
  private static RobotMissionResult robot(
      String name, double north, double speed, List<TeammateDistance> teammates) {
    List<Sample> samples = new ArrayList<>();
    for (int i = 1; i <= 100; i++) {
      double time = i / 10.0;
      samples.add(
          new Sample(time, speed * time, north, 0, speed, 0, 0, 0, Double.NaN, Double.NaN, 0, 1));
    }
    ModuleReadings readings = new ModuleReadings(List.of(), List.of(), List.of(), teammates);
    return new RobotMissionResult(name, true, "it ends", samples, Map.of(), readings);
  }

  @Test
  void comparesWithTheTruthOfThatInstant() {
    List<TeammateDistance> teammates =
        List.of(
            new TeammateDistance(0.02, "atrv2", 99, CLOCK), // before the first sample
            new TeammateDistance(2.05, "atrv3", 99, CLOCK), // another robot
            new TeammateDistance(2.05, "atrv2", 5.0, CLOCK),
            new TeammateDistance(4.0, "atrv2", 6.0, CLOCK),
            new TeammateDistance(12, "atrv2", 99, CLOCK)); // after the last
    List<RobotSeparation> all =
        RobotSeparation.all(robot("atrv1", 0, -1, teammates), robot("atrv2", 3, 1, List.of()));
    assertThat(all).extracting(RobotSeparation::time).containsExactly(2.05, 4.0);
    // Each is 1 m/s on its way, 3 m beside the other.
    assertThat(all.get(0).actual()).isCloseTo(Math.hypot(4.1, 3), within(1e-9));
    assertThat(all.get(1).actual()).isCloseTo(Math.hypot(8, 3), within(1e-9));
    double first = Math.hypot(4.1, 3) - 5;
    double second = Math.hypot(8, 3) - 6;
    assertThat(RobotSeparation.rms(all))
        .isCloseTo(Math.sqrt((first * first + second * second) / 2), within(1e-9));
  }

  @Test
  void withoutReportedDistancesThereIsNoError() {
    List<RobotSeparation> none =
        RobotSeparation.all(robot("atrv1", 0, 1, List.of()), robot("atrv2", 3, 1, List.of()));
    assertThat(none).isEmpty();
    assertThat(RobotSeparation.rms(none)).isNaN();
  }
}
