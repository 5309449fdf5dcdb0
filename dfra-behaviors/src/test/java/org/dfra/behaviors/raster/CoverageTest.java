package org.dfra.behaviors.raster;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dfra.behaviors.raster.RasterPlan.Coverage;
import org.dfra.behaviors.raster.RasterPlan.Lane;
import org.dfra.geometry.LocalPosition;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CoverageTest {

  /** 20 m by 20 m around the origin. */
  private static final RasterPlan PLAN = RasterPlan.of(Field.rectangle(20, 20), 2.01, 2, 0);

  @Test
  void aWayNowhereSeesNothing() {
    assertThat(PLAN.coverage(List.of(), 2).share()).isZero();
    assertThat(PLAN.coverage(List.of(at(50, 50), at(90, 50)), 2).share()).isZero();
  }

  @Test
  void oneStraightWaySeesAStripOfItsWidth() {
    Coverage coverage = PLAN.coverage(List.of(at(-30, 3), at(30, 3)), 4);
    assertThat(coverage.share()).isCloseTo(0.2, within(2 * coverage.cellSize() / 20));
    assertThat(coverage.overlap()).isZero();
  }

  @Test
  void whereTheRobotStandsItSeesADisc() {
    Coverage coverage = PLAN.coverage(List.of(at(0, 0)), 8);
    assertThat(coverage.share()).isCloseTo(16 * Math.PI / 400, within(1e-3));
  }

  @Test
  void twoStripsOverlapWhereTheyDo() {
    Coverage coverage = PLAN.coverage(List.of(at(-30, 1), at(30, 1), at(30, -2), at(-30, -2)), 4);
    // the first from −1 to 3, the second from −4 to 0
    assertThat(coverage.share()).isCloseTo(7 / 20.0, within(2 * coverage.cellSize() / 20));
    assertThat(coverage.overlap()).isCloseTo(1 / 20.0, within(2 * coverage.cellSize() / 20));
  }

  @Test
  void theMapShowsWhatTheShareCounts() {
    List<LocalPosition> way = List.of(at(-30, 1), at(30, 1), at(30, -2), at(-30, -2));
    CoverageMap map = PLAN.coverageMap(way, 4);
    assertThat(map.share()).isCloseTo(7 / 20.0, within(2 * map.cellSize() / 20));
    assertThat(map.west()).isCloseTo(-10, within(1e-3));
    assertThat(map.north()).isBetween(9.999, 10 + map.cellSize());
    for (int row = 0; row < map.passes().size(); row++) {
      double north = map.south() + (row + 0.5) * map.cellSize();
      int passes = (Math.abs(north - 1) < 2 ? 1 : 0) + (Math.abs(north + 2) < 2 ? 1 : 0);
      if (north < 10 && Math.abs(Math.abs(north - 1) - 2) > 0.01) {
        assertThat(map.passes().get(row)).as("north %s", north).startsWith(passes, passes);
      }
    }
  }

  @Test
  void mapsOfRegionsInDifferentPlacesAreNotMerged() {
    CoverageMap map = PLAN.coverageMap(List.of(), 4);
    assertThat(map.and(map)).isEqualTo(map);
    for (CoverageMap moved :
        List.of(
            new CoverageMap(map.west() + 1, map.south(), map.cellSize(), map.passes()),
            new CoverageMap(map.west(), map.south() + 1, map.cellSize(), map.passes()))) {
      assertThatThrownBy(() -> map.and(moved))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessage(
              "coverage maps of different regions or swaths cannot be merged; make both with one"
                  + " plan and one swath");
    }
  }

  @Test
  void theMapOfANotchedRegionHasCellsOutsideIt() {
    RasterPlan plan = RasterPlan.of(Field.region(0, 0, 20, 0, 20, 20, 10, 10, 0, 20), 2, 2, 0);
    assertThat(plan.coverageMap(List.of(), 2).passes())
        .anySatisfy(row -> assertThat(row).contains(CoverageMap.OUTSIDE, 0));
  }

  @Test
  void manySmallStepsAreOnePass() {
    List<LocalPosition> steps = new ArrayList<>();
    Random random = new Random(1);
    for (int i = 0; i <= 5000; i++) {
      steps.add(at(-25 + i * 0.01, 3 + 0.02 * random.nextGaussian()));
    }
    Coverage coverage = PLAN.coverage(steps, 4);
    assertThat(coverage.share()).isCloseTo(0.2, within(0.01));
    assertThat(coverage.overlap()).isLessThan(0.01);
  }

  @Test
  void aPlanSeesAllOfItsRegionAndWithoutGapsBetweenLanesNothingTwice() {
    Coverage whole = PLAN.coverage(PLAN.path(), 2.01);
    assertThat(whole.share()).isEqualTo(1);
    assertThat(whole.overlap()).as("a centimetre in two metres, and squares").isLessThan(0.05);
    Coverage narrow = PLAN.coverage(PLAN.path(), 1);
    assertThat(narrow.share()).as("half the swath, and the turns").isBetween(0.5, 0.6);
  }

  @Test
  void agreesWithPointsDrawnByLot() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    RandomRegions regions = new RandomRegions(random);
    for (int i = 0; i < 10; i++) {
      Region region = regions.next(RandomRegions.Kind.STAR);
      BruteOutline outline = new BruteOutline(region);
      RasterPlan plan = RasterPlan.of(region, 2, 2, 0);
      double seen = 1.2; // less than the swath, so that something is left
      Coverage coverage = plan.coverage(plan.path().subList(0, plan.path().size() / 2), seen);
      int inside = 0;
      int hit = 0;
      for (int k = 0; k < 20_000; k++) {
        double[] point = outline.around(random); // of a wider box a small region may get none
        if (outline.holds(point[0], point[1])) {
          inside++;
          hit += isSeen(point, plan.path().subList(0, plan.path().size() / 2), seen) ? 1 : 0;
        }
      }
      // five standard deviations of a share of so many points, and the squares
      assertThat(coverage.share())
          .as("-Ddfra.seed=%d, region %d: %s", seed, i, outline)
          .isCloseTo((double) hit / inside, within(2.5 / Math.sqrt(inside) + 0.02));
    }
  }

  @ParameterizedTest
  @CsvSource({"100, 0, 0.01", "700, 300, 0.00005"})
  void aRegionThinnerThanASquareIsSeenToo(double east, double north, double width) {
    Region region = Field.region(0, 0, east, north, east, north + width, 0, width);
    RasterPlan plan = RasterPlan.of(region, 2, 2, Math.atan2(north, east));
    Coverage whole = plan.coverage(plan.path(), 2);
    assertThat(whole.cellSize())
        .as("few middles of squares are inside, if any")
        .isGreaterThan(width);
    // the middle of a square at its end lies outside, where the robot need not look
    assertThat(whole.share()).isCloseTo(1, within(2e-3));
    assertThat(plan.coverage(List.of(at(-1000, 1000)), 2).share()).isZero();
    LocalPosition middle = at(0, 0);
    assertThat(plan.coverage(List.of(plan.path().get(0), middle), 2).share())
        .isCloseTo(0.5, within(0.02));
    assertThat(plan.coverageMap(plan.path(), 2).share()).isCloseTo(1, within(6e-3)); // coarser
  }

  @Test
  void refusesASwathThatIsNone() {
    assertThatThrownBy(() -> PLAN.coverage(PLAN.path(), 0))
        .hasMessage("a swath of 0.0 m is not above 0; give a greater one");
  }

  private static boolean isSeen(double[] point, List<LocalPosition> path, double swath) {
    for (int i = 1; i < path.size(); i++) {
      Lane leg = new Lane(path.get(i - 1), path.get(i), PLAN.lanes().get(0).leg(), 0);
      if (BruteOutline.distance(point, leg) <= swath / 2) {
        return true;
      }
    }
    return false;
  }

  private static LocalPosition at(double east, double north) {
    return new LocalPosition(east, north, 0);
  }
}
