package org.dfra.examples.raster;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.examples.mission.HandMade;
import org.dfra.examples.mission.MissionProgressListener.RobotProgress;
import org.dfra.examples.mission.RobotLog.Sample;
import org.dfra.examples.mission.Scenario;
import org.dfra.geometry.GeoPosition;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.description.WorldDescription;
import org.junit.jupiter.api.Test;

/** What is printed while a search runs; the test sets its real time. */
class LiveProgressTest {

  private static final Scenario SCENARIO =
      new Scenario(
          new WorldDescription("field", 1, new GeoPosition(48, 11, 0), 40, 30)
              .with(new VehicleDescription("atrv1", VehicleType.UGV, 3, 3, 0))
              .with(new VehicleDescription("atrv2", VehicleType.UGV, 30, 3, 0)),
          List.of(),
          HandMade.region(),
          2.001,
          2);

  private final AtomicLong nanos = new AtomicLong();
  private final StringWriter out = new StringWriter();

  /** A search of 86 s, of which a tenth of a second takes so much real time. */
  private void watch(boolean isTerminal, long millis) {
    LiveProgress progress =
        new LiveProgress(
            new ProgressReporter(new PrintWriter(out, true), nanos::get, isTerminal),
            nanos::get,
            SCENARIO);
    List<Sample> one = HandMade.drive(SCENARIO.plan(0), 0.25, 0.125, 8);
    List<Sample> other = HandMade.drive(SCENARIO.plan(1), 0, 0, 8);
    for (int i = 0; i < one.size(); i++) {
      nanos.addAndGet(TimeUnit.MILLISECONDS.toNanos(millis));
      progress.onProgress(List.of(at("atrv1", one.get(i)), at("atrv2", other.get(i))));
    }
  }

  private static RobotProgress at(String robot, Sample sample) {
    BehaviorStatus status =
        new BehaviorStatus(Instant.EPOCH, null, Phase.RUNNING, "lane 1 of 4", sample.done(), 0);
    return new RobotProgress(robot, sample, status);
  }

  @Test
  void printsASentenceEveryTenSecondsWhereThereIsNoTerminal() {
    watch(false, 100);
    assertThat(out.toString()).doesNotContain("\u001b");
    String text = out.toString().replaceAll("\\s+", " ");
    assertThat(text.split("After ", -1)).as(text).hasSize(1 + 8); // in 86 s
    assertThat(text)
        .contains("After 10 s, ", " m apart, minimum clearance so far 1.", "atrv1 has seen 1")
        .contains("(lane 1 of 4, 0.13 m off it)");
  }

  @Test
  void redrawsABlockEverySecondOnATerminal() {
    watch(true, 20); // 17.2 s in all
    String text = out.toString();
    assertThat(text.split("\u001b\\[4A\u001b\\[J", -1)).as("blocks drawn over others").hasSize(17);
    assertThat(text)
        .contains("ROBOT", "STATE", "COVERED", "CROSS-TRACK", "ACTIVITY", "running", "0.13 m");
    assertThat(text.substring(text.lastIndexOf("After"))).startsWith("After 85 s");
  }

  @Test
  void aFastSearchIsOverBeforeThereIsAnythingToReport() {
    watch(false, 1);
    assertThat(out.toString()).isEmpty();
  }
}
