package org.dfra.behaviors.perceptual.mines;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import org.dfra.behaviors.perceptual.mines.MineObservation.GroundPoint;
import org.dfra.behaviors.perceptual.mines.MineObservation.Viewpoint;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.junit.jupiter.api.Test;

class PoseBufferTest {

  private static final GeoPosition DATUM = new GeoPosition(48, 11, 0);

  private final PoseBuffer trail = new PoseBuffer();

  private static Instant at(double seconds) {
    return Instant.EPOCH.plusNanos(Math.round(seconds * 1e9));
  }

  private static PoseEstimate pose(GeoPosition datum, double seconds, double east, double yaw) {
    return new PoseEstimate(
        at(seconds), "robot/map", datum, east, 0, yaw, 1, 0, 0.1, 0.01, null, null);
  }

  @Test
  void anImageBetweenPosesIsLaidWhereTheRobotWasThen() {
    trail.add(pose(DATUM, 10, 5, 0));
    trail.add(pose(DATUM, 10.5, 5.5, 0));
    PoseEstimate near = trail.nearest(at(10.2)).orElseThrow();
    assertThat(near.measured()).isEqualTo(at(10));
    assertThat(trail.extrapolate(at(10.2), near).east()).isCloseTo(5.2, within(1e-9));
    assertThat(trail.extrapolate(at(9.9), near).east())
        .as("before the first")
        .isCloseTo(4.9, within(1e-9));
  }

  @Test
  void anImageFarFromAllPosesIsLaidNowhere() {
    trail.add(pose(DATUM, 10, 5, 0));
    assertThat(trail.nearest(at(10.5))).isEmpty();
    assertThat(trail.nearest(at(9.5))).isEmpty();
  }

  @Test
  void whereAnotherDatumCountsTheMapStays() {
    LocalFrame frame = new LocalFrame(DATUM);
    trail.add(pose(DATUM, 10, 5, 0));
    PoseEstimate moved = pose(frame.toGeo(new LocalPosition(3, 4, 0)), 11, 5, 0);
    trail.add(moved);
    Viewpoint from = trail.extrapolate(at(11), moved);
    assertThat(from.east()).isCloseTo(8, within(1e-4));
    assertThat(from.north()).isCloseTo(4, within(1e-4));
    assertThat(frame.toLocal(trail.toGeo(new GroundPoint(8, 4))).east()).isCloseTo(8, within(1e-6));
  }
}
