package org.dfra.behaviors.raster;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behavior.RasterGoal;
import org.dfra.behaviors.raster.RasterPlan.Lane;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalPosition;
import org.junit.jupiter.api.Test;

class RasterPlanTest {

  private static final double EXACT = 1e-3; // metres: a field is not quite a rectangle on the earth

  @Test
  void laysEvenLanesOverARectangleFromWestToEastAndTheFirstNorthward() {
    RasterPlan plan = RasterPlan.of(Field.rectangle(30, 20), 2, 1.6, RasterPlan.NORTHWARD);
    assertThat(plan.lanes()).as("30 m / 1.6 m, rounded up").hasSize(19);
    assertThat(plan.spacing()).isCloseTo(30 / 19.0, within(EXACT));
    for (int i = 0; i < 19; i++) {
      Lane lane = plan.lanes().get(i);
      double east = -15 + (i + 0.5) * 30 / 19;
      assertThat(lane.from().east()).isCloseTo(east, within(EXACT));
      assertThat(lane.to().east()).isCloseTo(east, within(EXACT));
      assertThat(lane.to().north() - lane.from().north())
          .isCloseTo(i % 2 == 0 ? 20 : -20, within(EXACT));
      assertThat(lane.leg().length()).isCloseTo(lane.length(), within(1e-6));
    }
    assertThat(plan.waypoints()).hasSize(38);
    assertThat(plan.length()).isCloseTo(19 * 20 + 18 * 30 / 19.0, within(0.05));
  }

  @Test
  void plansWhatAGoalAsksForAndItsReverse() {
    List<GeoPosition> corners = Field.positions(0, 0, 30, 0, 30, 20, 0, 20);
    RasterPlan there = RasterPlan.of(new RasterGoal(corners, 2, 1.6, false));
    RasterPlan back = RasterPlan.of(new RasterGoal(corners, 2, 1.6, true));
    assertThat(back.waypoints().get(0)).isEqualTo(there.waypoints().get(37));
    assertThat(back.lanes().get(0).from()).isEqualTo(there.lanes().get(18).to());
  }

  @Test
  void laysOneLaneAlongTheMiddleOfWhatIsNarrowerThanTheSpacing() {
    RasterPlan plan = RasterPlan.of(Field.rectangle(1.5, 20), 2, 2, 0);
    assertThat(plan.lanes()).hasSize(1);
    assertThat(plan.lanes().get(0).from().east()).isCloseTo(0, within(EXACT));
    assertThat(plan.length()).isCloseTo(20, within(EXACT));
  }

  @Test
  void lanesFollowTheirBearing() {
    RasterPlan plan = RasterPlan.of(Field.rectangle(30, 20), 2.01, 2, Math.PI / 2);
    assertThat(plan.lanes()).as("lanes to the east and back").hasSize(10);
    Lane first = plan.lanes().get(0);
    assertThat(first.to().east() - first.from().east()).isCloseTo(30, within(EXACT));
    assertThat(first.from().north()).as("the left is in the north").isCloseTo(9, within(EXACT));
  }

  @Test
  void drivesOneSideOfANotchAfterTheOther() {
    // open to the east, the notch from 8 m to 20 m north
    Region region = Field.region(0, 0, 30, 0, 30, 8, 12, 8, 12, 20, 30, 20, 30, 30, 0, 30);
    RasterPlan plan = RasterPlan.of(region, 2, 1.6, 0);
    LocalPosition south = region.frame().toLocal(Field.positions(12, 8).get(0));
    List<Boolean> sides =
        plan.lanes().stream()
            .filter(lane -> lane.from().east() > south.east() + 0.1)
            .map(lane -> lane.from().north() > south.north() + EXACT)
            .toList();
    long changes = 0;
    for (int i = 1; i < sides.size(); i++) {
      changes += sides.get(i).equals(sides.get(i - 1)) ? 0 : 1;
    }
    assertThat(sides).hasSizeGreaterThan(20).contains(true, false);
    assertThat(changes).as("times it goes around the notch").isEqualTo(1);
  }

  @Test
  void drivesAlongASlantingEdgeWhatTheLanesLeave() {
    Region triangle = Field.region(0, 0, 10, 0, 10, 40);
    RasterPlan plan = RasterPlan.of(triangle, 2.01, 2, 0);
    long slanting =
        plan.lanes().stream()
            .filter(lane -> Math.abs(lane.from().east() - lane.to().east()) > 0.05)
            .count();
    // five lanes; each but the last leaves a sliver beside its end that the next one does not see
    assertThat(plan.lanes().size() - slanting).isEqualTo(5);
    assertThat(slanting).isBetween(4L, 5L);
  }

  @Test
  void refusesMoreLanesThanAnyRobotDrives() {
    assertThatThrownBy(() -> RasterPlan.of(Field.rectangle(1999.95, 20), 0.2, 0.1, 0))
        .isInstanceOf(GoalRefusedException.class)
        .hasMessageContaining(
            " m wide, which makes 20000 lanes 0.1 m apart, more than 10000; give a greater"
                + " spacing, or search it in parts");
  }

  @Test
  void refusesASpacingThatDoesNotCover() {
    assertThatThrownBy(() -> RasterPlan.of(Field.rectangle(20, 20), 1, 2, 0))
        .hasMessage(
            "lanes 2.0 m apart do not cover with a swath of 1.0 m; give a spacing not greater than"
                + " the swath");
    assertThatThrownBy(() -> RasterPlan.of(Field.rectangle(20, 20), 2, Double.NaN, 0))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
