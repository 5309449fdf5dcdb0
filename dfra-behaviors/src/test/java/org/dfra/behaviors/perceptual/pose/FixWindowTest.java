package org.dfra.behaviors.perceptual.pose;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.dfra.behaviors.perceptual.pose.FilterInput.LocalFix;
import org.junit.jupiter.api.Test;

class FixWindowTest {

  private static final double YAW = 2.4;
  private static final double EAST = -12;
  private static final double NORTH = 33;

  private final FixWindow window = new FixWindow(TrackerTable.settings(0));

  /** Adds a fix of the antenna 0.3 m ahead, a track laid into the map by the constants above. */
  private void add(int i, int slot, double biasEast, double noiseEast, double noiseNorth) {
    DeadReckoningTrack.Pose pose = new DeadReckoningTrack.Pose(0.6 * i, 0.02 * i * i, 0.04 * i);
    double x = pose.x() + 0.3 * Math.cos(pose.yaw());
    double y = pose.y() + 0.3 * Math.sin(pose.yaw());
    window.add(
        new LocalFix(
            i * EpochNanos.SECOND,
            slot,
            false,
            EAST + Math.cos(YAW) * x - Math.sin(YAW) * y + biasEast + noiseEast,
            NORTH + Math.sin(YAW) * x + Math.cos(YAW) * y + noiseNorth,
            0.3,
            0,
            0.6,
            0,
            Double.NaN),
        pose,
        0.6,
        0);
  }

  @Test
  void findsTheTurnAndShiftOfExactFixes() {
    for (int i = 0; i < 10; i++) {
      add(i, 0, 0, 0, 0);
    }
    Alignment found = window.align().orElseThrow();
    assertThat(found.yaw()).isCloseTo(YAW, within(1e-9));
    DeadReckoningTrack.Pose origin = new DeadReckoningTrack.Pose(0, 0, 0);
    assertThat(found.east() + found.eastward(origin)).isCloseTo(EAST, within(1e-9));
    assertThat(found.north() + found.northward(origin)).isCloseTo(NORTH, within(1e-9));
  }

  @Test
  void aReceiversSlowErrorDoesNotTurnIt() {
    // The first half of the way is from one receiver, the second from another 2 m beside.
    for (int i = 0; i < 10; i++) {
      add(i, i < 5 ? 0 : 1, i < 5 ? 0 : 2, 0, 0);
    }
    Alignment found = window.align().orElseThrow();
    assertThat(found.yaw()).isCloseTo(YAW, within(1e-9));
  }

  @Test
  void leavesAnOutlierOut() {
    for (int i = 0; i < 19; i++) {
      add(i, 0, 0, i == 7 ? 50 : 0, i == 7 ? -30 : 0);
    }
    assertThat(window.align().orElseThrow().yaw()).isCloseTo(YAW, within(1e-9));
  }

  @Test
  void isAsCertainOfItsYawAsItSays() {
    Random random = new Random(5);
    double square = 0;
    int rounds = 400;
    for (int round = 0; round < rounds; round++) {
      window.clear();
      for (int i = 0; i < 15; i++) {
        add(i, 0, 0, 0.6 * random.nextGaussian(), 0.6 * random.nextGaussian());
      }
      Alignment found = window.align().orElseThrow();
      double error = Math.IEEEremainder(found.yaw() - YAW, 2 * Math.PI) / found.yawSigma();
      square += error * error / rounds;
    }
    // A mean of 400 squares of normal numbers is 1 ± 0.07; three of these are allowed.
    assertThat(square).isBetween(0.79, 1.21);
  }
}
