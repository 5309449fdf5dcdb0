package org.dfra.examples.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.dfra.behaviors.raster.RasterPlan;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.world.description.WorldDescription;
import org.junit.jupiter.api.Test;

/** Scores of searches whose scores are known beforehand. */
class ScoresTest {

  private static final double MICRO = 1e-6;
  private static final RasterPlan PLAN = HandMade.plan();

  @Test
  void aPerfectSearchIsPerfect() {
    Scores scores = Scores.of(HandMade.flight(HandMade.drive(PLAN, 0, 0, 8), true), PLAN);
    assertThat(scores.completed()).isTrue();
    assertThat(scores.coverage()).isEqualTo(1);
    assertThat(scores.length()).isCloseTo(86, within(0.001)); // 4 · 20 m, 3 · 2 m
    assertThat(scores.plannedLength()).isCloseTo(86, within(0.001));
    assertThat(scores.seconds()).isEqualTo(86);
    assertThat(scores.crossTrack()).isEqualTo(scores.trueCrossTrack());
    assertThat(scores.crossTrack().most()).isLessThan(MICRO);
    assertThat(scores.waypointErrors().most()).isLessThan(MICRO);
    assertThat(scores.estimateError()).isZero();
    assertThat(scores.fixError()).isCloseTo(5, within(MICRO));
    assertThat(scores.clearance()).isEqualTo(1); // at the end, when all is done
  }

  @Test
  void whatItBelievesAndWhereItIsAreScoredSeparately() {
    Scores scores = Scores.of(HandMade.flight(HandMade.drive(PLAN, 0.4, -0.1, 8), true), PLAN);
    assertThat(scores.trueCrossTrack().rms()).isCloseTo(0.4, within(MICRO));
    assertThat(scores.trueCrossTrack().mean()).isCloseTo(0.4, within(MICRO));
    assertThat(scores.trueCrossTrack().within95()).isCloseTo(0.4, within(MICRO));
    assertThat(scores.crossTrack().rms()).isCloseTo(0.1, within(MICRO));
    assertThat(scores.crossTrack().most()).isCloseTo(0.1, within(MICRO));
    assertThat(scores.estimateError()).isCloseTo(0.5, within(MICRO));
    // 0.4 m to the east of each waypoint; on the way between lanes it comes nearer to some
    assertThat(scores.waypointErrors().most()).isCloseTo(0.4, within(MICRO));
    assertThat(scores.coverage()).isBetween(0.9, 0.96); // all but a strip of 0.4 m of 8 m
  }

  @Test
  void halfASearchIsScoredAsFarAsItCame() {
    Scores scores = Scores.of(HandMade.flight(HandMade.drive(PLAN, 0, 0, 4), false), PLAN);
    assertThat(scores.completed()).isFalse();
    assertThat(scores.coverage()).isCloseTo(0.5, within(0.02));
    assertThat(scores.length()).isCloseTo(42, within(0.001));
    assertThat(scores.waypointErrors().most()).isLessThan(MICRO);
  }

  @Test
  void togetherTwoHalvesAreTheWhole() {
    Scenario scenario =
        new Scenario(
            new WorldDescription("field", 1, new GeoPosition(48, 11, 0), 40, 30),
            List.of(),
            HandMade.region(),
            2.001,
            2);
    RobotMissionResult west = HandMade.flight(HandMade.drive(PLAN, 0, 0, 4), false);
    RobotMissionResult east = HandMade.flight(HandMade.drive(PLAN.reversed(), 0, 0, 4), false);
    assertThat(
            Scores.teamCoverage(
                new MissionResult(List.of(west), List.of(), List.of(), 42), scenario))
        .isCloseTo(0.5, within(0.03));
    assertThat(
            Scores.teamCoverage(
                new MissionResult(List.of(west, east), List.of(), List.of(), 42), scenario))
        .isEqualTo(1);
  }

  @Test
  void aSearchThatNeverBeganHasNoScores() {
    Scores scores = Scores.of(HandMade.flight(List.of(), false), PLAN);
    assertThat(scores.coverage()).isZero();
    assertThat(scores.crossTrack().rms()).isNaN();
    assertThat(scores.waypointErrors().mean()).isNaN();
  }

  @Test
  void theSideOfALaneIsGivenInTheDirectionOfTravel() {
    List<CrossTrackError> off = CrossTrackError.all(HandMade.drive(PLAN, 0.5, 0.5, 8), PLAN);
    assertThat(off).filteredOn(each -> each.lane() == 1).isNotEmpty();
    assertThat(off)
        .allSatisfy( // the first lane leads north, so east of it is right; the second leads south
            each ->
                assertThat(each.actual())
                    .isCloseTo(each.lane() % 2 == 1 ? -0.5 : 0.5, within(MICRO)));
    // 20 m less 2 m at either end, ten samples to the metre
    assertThat(off).filteredOn(each -> each.lane() == 2).hasSizeBetween(159, 161);
  }
}
