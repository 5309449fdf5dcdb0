package org.dfra.examples.raster;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.dfra.examples.mission.HandMade;
import org.dfra.examples.mission.MissionProgressListener.MissionEvent;
import org.dfra.examples.mission.MissionResult;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.examples.mission.ModuleReadings;
import org.dfra.examples.mission.ModuleReadings.Advice;
import org.dfra.examples.mission.ModuleReadings.Fix;
import org.dfra.examples.mission.Scenario;
import org.dfra.examples.mission.Scores;
import org.dfra.examples.raster.Downsampling.Bin;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.description.WorldDescription;
import org.junit.jupiter.api.Test;

/** The report of a search that was made by hand. */
class RasterChartsTest {

  private static final Scenario SCENARIO =
      new Scenario(
          new WorldDescription("field", 1, new GeoPosition(48, 11, 0), 40, 30)
              .with(new VehicleDescription("atrv1", VehicleType.UGV, 3, 3, 0)),
          List.of(),
          HandMade.region(),
          2.001,
          2);

  private static MissionResult flight() {
    List<Fix> fixes = List.of(new Fix(0.5, "gps_front", 0, 0), new Fix(40, "gps_front", 0, 0));
    List<Advice> advice =
        List.of(
            new Advice(1, 0.5, 0, "ahead, fast", 0.5),
            new Advice(1.1, 0.7, 0, "ahead, fast", 1),
            new Advice(9, 0.1, 0.4, "close, hard left", 0.25));
    RobotMissionResult robot =
        new RobotMissionResult(
            "atrv1",
            true,
            "it ends",
            HandMade.drive(HandMade.plan(), 0.4, 0, 8),
            Map.of(),
            new ModuleReadings(fixes, advice, List.of(), List.of()));
    return new MissionResult(
        List.of(robot), List.of(), List.of(new MissionEvent(12, "atrv1", "gps killed")), 86);
  }

  @Test
  void whatHappenedAndSilentReceiversAreMarked() {
    RasterCharts figures = new RasterCharts(SCENARIO, flight());
    assertThat(figures.crossTrack().svg()).contains(">1<", "gps_front silent");
    assertThat(figures.clearance().svg())
        .contains(">1<", "required minimum")
        .doesNotContain("Distance from body to body"); // there is one robot only
  }

  @Test
  void pathsHaveTheirDirectionAndTheSameColourAsTheirDistancesFromTheLanes() {
    RasterCharts figures = new RasterCharts(SCENARIO, flight());
    String estimates = figures.estimates().svg();
    assertThat(estimates).contains(">start, direction, end<");
    for (String name : List.of(">true<", ">estimated<")) {
      assertThat(sample(estimates, name)).isEqualTo(sample(figures.crossTrack().svg(), name));
    }
  }

  /** The colour that was set last before a name of the legend was written in ink. */
  private static String sample(String svg, String name) {
    String before = svg.substring(0, svg.indexOf(name));
    List<String> strokes =
        Pattern.compile("stroke=\"(rgb\\([^)]*\\))\"")
            .matcher(before)
            .results()
            .map(each -> each.group(1))
            .toList();
    return strokes.get(strokes.size() - 1);
  }

  @Test
  void theLoudestRulesAreCountedAndTheirStrengthIsTheMean() {
    assertThat(DominantRules.table(flight(), 1))
        .containsExactly(
            List.of("atrv1", "Strength, mean", "Rule"), List.of("2", "0.75", "ahead, fast"));
    assertThat(DominantRules.table(flight(), 10)).hasSize(3);
  }

  @Test
  void theTablesHaveTheNumbersAndTheirUnits() {
    MissionResult flight = flight();
    List<Scores> scores = List.of(Scores.of(flight.robots().get(0), SCENARIO.plan()));
    assertThat(MetricsTable.of(flight, scores, 0.995).rows())
        .contains(
            List.of("completed its lanes", "yes"),
            List.of("collisions", "0"),
            List.of("… by it or another", "99.5 %"),
            List.of("cross-track error, true, RMS", "0.40 m"),
            List.of("cross-track error, estimated, RMS", "0.00 m"),
            List.of("distance driven", "86.00 m"),
            List.of("time", "86 s"));
    assertThat(MetricsTable.besidePublished(flight, scores).rows())
        .contains(
            List.of("atrv1, true", "0.40 m", "86 m"),
            List.of("Columbia AVENUE, outdoors", "0.46 m", "210 m, 14 waypoints"));
  }

  @Test
  void aBinHasTheLeastOrTheMeanAndALineBreaksWhereThereIsNone() {
    List<double[]> points =
        List.of(
            new double[] {0.1, 4},
            new double[] {0.9, 2},
            new double[] {1.5, 7},
            new double[] {5.5, 1});
    double[][] least = Downsampling.binned(points, 1, Bin.MIN, p -> p[0], p -> p[1]);
    assertThat(least[0]).containsExactly(0.5, 1.5, 5.5, 5.5);
    assertThat(least[1]).containsExactly(2, 7, Double.NaN, 1);
    assertThat(Downsampling.binned(points, 1, Bin.MEAN, p -> p[0], p -> p[1])[1])
        .containsExactly(3, 7, Double.NaN, 1);
  }

  @Test
  void aThinnedPathKeepsItsEnds() {
    List<Integer> ten = List.of(0, 1, 2, 3, 4, 5, 6, 7, 8, 9);
    assertThat(Downsampling.thinned(ten, 4, i -> i, i -> -i)[0]).containsExactly(0, 4, 8, 9);
  }
}
