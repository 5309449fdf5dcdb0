package org.dfra.drivers.pantilt.ptu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.dfra.core.geometry.FrameTree;
import org.dfra.drivers.pantilt.ptu.PtuImpl.HeadPose;
import org.dfra.geometry.Transform;
import org.junit.jupiter.api.Test;

/** The pose compared with a tree of frames, one for each rotation, computed with matrices. */
class HeadPoseTest {

  @Test
  void isTheMountThenPanThenTilt() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    for (int i = 0; i < 1000; i++) {
      Transform mount =
          Transform.of(
              random.nextGaussian(),
              random.nextGaussian(),
              random.nextGaussian(),
              random.nextGaussian(),
              random.nextGaussian(),
              random.nextGaussian());
      double pan = random.nextGaussian();
      double tilt = random.nextGaussian();
      FrameTree tree = new FrameTree();
      tree.put("mount", "base", mount);
      tree.put("panned", "mount", Transform.of(0, 0, 0, 0, 0, pan));
      tree.put("head", "panned", Transform.of(0, 0, 0, 0, -tilt, 0));
      assertThat(difference(HeadPose.of(mount, pan, tilt), tree.transform("head", "base")))
          .as("-Ddfra.seed=%d, try %s", seed, i)
          .isLessThan(1e-12);
    }
  }

  @Test
  void looksUpWhenItTiltsUpAndLeftWhenItPansLeft() {
    Transform up = HeadPose.of(Transform.IDENTITY, 0, Math.toRadians(30));
    assertThat(up.pitch()).as("nose down is +").isCloseTo(Math.toRadians(-30), within(1e-12));
    Transform left = HeadPose.of(Transform.translation(0.3, 0, 0.5), Math.toRadians(90), 0);
    assertThat(left.yaw()).isCloseTo(Math.toRadians(90), within(1e-12));
    FrameTree tree = new FrameTree();
    tree.put(
        "head", "base", HeadPose.of(Transform.translation(0.3, 0, 0.5), Math.PI / 2, Math.PI / 6));
    tree.put("camera", "head", Transform.translation(2, 0, 0));
    Transform camera = tree.transform("camera", "base");
    assertThat(camera.x()).isCloseTo(0.3, within(1e-12));
    assertThat(camera.y()).as("two metres to the left, 30° up").isCloseTo(1.7320508, within(1e-6));
    assertThat(camera.z()).isCloseTo(0.5 + 1, within(1e-12));
  }

  /** The greatest difference; a quaternion and its negative are the same rotation. */
  private static double difference(Transform a, Transform b) {
    double sign = a.qw() * b.qw() + a.qx() * b.qx() + a.qy() * b.qy() + a.qz() * b.qz();
    double s = Math.signum(sign);
    double[] differences = {
      a.x() - b.x(),
      a.y() - b.y(),
      a.z() - b.z(),
      a.qw() - s * b.qw(),
      a.qx() - s * b.qx(),
      a.qy() - s * b.qy(),
      a.qz() - s * b.qz()
    };
    double most = 0;
    for (double difference : differences) {
      most = Math.max(most, Math.abs(difference));
    }
    return most;
  }
}
