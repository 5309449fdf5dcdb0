package org.dfra.behaviors.raster;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.dfra.behaviors.raster.RasterPlan.Lane;
import org.dfra.geometry.LocalPosition;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What is promised of every plan, tried with regions drawn by lot. */
class RasterPlanPropertiesTest {

  private static final int REGIONS = Boolean.getBoolean("dfra.full") ? 1_000 : 40;
  private static final int POINTS = 1_000;

  /** Metres. */
  private static final double PROMISED = 1e-6;

  @ParameterizedTest
  @EnumSource
  void seesEveryPointAndStaysInsideAndDrivesNoMoreThanItMust(RandomRegions.Kind kind) {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    RandomRegions regions = new RandomRegions(random);
    for (int i = 0; i < REGIONS; i++) {
      Region region = regions.next(kind);
      BruteOutline outline = new BruteOutline(region);
      double swath = 0.5 + 4 * random.nextDouble();
      double spacing = random.nextInt(4) == 0 ? swath : swath * (0.4 + 0.6 * random.nextDouble());
      double bearing = random.nextBoolean() ? RasterPlan.NORTHWARD : 7 * random.nextDouble();
      String what =
          "-Ddfra.seed=%d, region %d: swath %s, spacing %s, bearing %s over %s"
              .formatted(seed, i, swath, spacing, bearing, outline);
      RasterPlan plan = RasterPlan.of(region, swath, spacing, bearing);
      assertThat(plan.spacing()).as(what).isLessThanOrEqualTo(spacing * 1.001);
      requireSeen(plan, outline, random, what);
      requireInside(plan, outline, what);
      requireShort(plan, outline, what);
      requireSameBackwards(plan, what);
    }
  }

  private static void requireSeen(
      RasterPlan plan, BruteOutline outline, Random random, String what) {
    double allowed = plan.swath() / 2 + PROMISED;
    for (int i = 0; i < POINTS; i++) {
      double[] point = outline.point(random, plan.path(), plan.swath() / 2);
      double nearest = Double.POSITIVE_INFINITY;
      for (int k = 0; k < plan.lanes().size() && nearest > allowed; k++) {
        nearest = Math.min(nearest, BruteOutline.distance(point, plan.lanes().get(k)));
      }
      if (!(nearest <= allowed)) { // asked millions of times
        throw new AssertionError(
            "%s: %s m from %s to the nearest lane"
                .formatted(what, nearest, new LocalPosition(point[0], point[1], 0)));
      }
    }
  }

  private static void requireInside(RasterPlan plan, BruteOutline outline, String what) {
    List<LocalPosition> path = plan.path();
    for (int i = 1; i < path.size(); i++) {
      assertThat(outline.strays(path.get(i - 1), path.get(i)))
          .as("%s: outside from %s to %s", what, path.get(i - 1), path.get(i))
          .isLessThanOrEqualTo(PROMISED);
    }
    for (int i = 0; i < path.size(); i++) {
      LocalPosition back = plan.region().frame().toLocal(plan.waypoints().get(i));
      assertThat(Math.hypot(back.east() - path.get(i).east(), back.north() - path.get(i).north()))
          .as("%s: waypoint %d on the earth", what, i)
          .isLessThanOrEqualTo(PROMISED);
    }
  }

  /**
   * Lanes at that spacing have the length of area / spacing, but for what they gain or lose where
   * the outline slants. The ways between their ends follow the outline, half of it in all, and the
   * short lanes the other half; the rest is for what is left and come back to. 7500 regions needed
   * 1.2 times the outline at most.
   */
  private static void requireShort(RasterPlan plan, BruteOutline outline, String what) {
    double lanes = outline.area() / plan.spacing();
    assertThat(plan.length())
        .as("%s: the length of the way", what)
        .isLessThanOrEqualTo(lanes + 2 * outline.perimeter());
    List<Lane> all = plan.lanes();
    for (int i = 0; i < all.size(); i++) {
      for (int j = 0; j < i; j++) {
        if (areTheSame(all.get(i), all.get(j))) { // asked millions of times
          throw new AssertionError("%s: lanes %d and %d are the same".formatted(what, i, j));
        }
      }
    }
  }

  private static boolean areTheSame(Lane one, Lane other) {
    return one.from().equals(other.from()) && one.to().equals(other.to())
        || one.from().equals(other.to()) && one.to().equals(other.from());
  }

  private static void requireSameBackwards(RasterPlan plan, String what) {
    RasterPlan back = plan.reversed();
    List<Object> turned = new ArrayList<>(back.waypoints());
    Collections.reverse(turned);
    assertThat(turned).as(what).isEqualTo(plan.waypoints());
    assertThat(back.length()).as(what).isCloseTo(plan.length(), within(1e-6));
    int last = plan.lanes().size() - 1;
    for (int i = 0; i <= last; i++) {
      Lane lane = plan.lanes().get(i);
      Lane same = back.lanes().get(last - i);
      assertThat(same.from()).as(what).isEqualTo(lane.to());
      assertThat(same.leg().to()).as(what).isEqualTo(lane.leg().from());
      assertThat(back.waypoints().get(same.waypoint())).isEqualTo(same.leg().from());
      assertThat(plan.waypoints().get(lane.waypoint() + 1)).isEqualTo(lane.leg().to());
    }
    assertThat(back.reversed().waypoints()).as(what).isEqualTo(plan.waypoints());
  }
}
