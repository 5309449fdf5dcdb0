package org.dfra.core.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.dfra.geometry.Transform;
import org.junit.jupiter.api.Test;

class FrameTreeTest {

  private final FrameTree tree = new FrameTree();

  /**
   * By hand: the robot stands at (10, 5) in odom and looks north (yaw 90°). Its pan-tilt sits 0.4 m
   * ahead and 0.9 m up, panned 90° to the left, so it looks west. The camera sits 0.1 m ahead of
   * the pan-tilt's axis and 0.2 m above it, tilted nose down by 30°.
   *
   * <p>The pan-tilt in odom: (10 − 0, 5 + 0.4, 0.9). Ahead of it is west: the camera stands at (10
   * − 0.1, 5.4, 1.1), yaw 180°, pitch 30°.
   */
  @Test
  void composesCameraPanTiltBaseAndOdom() {
    tree.put("base_link", "odom", Transform.of(10, 5, 0, 0, 0, Math.PI / 2));
    tree.put("pan_tilt", "base_link", Transform.of(0.4, 0, 0.9, 0, 0, Math.PI / 2));
    tree.put("camera", "pan_tilt", Transform.of(0.1, 0, 0.2, 0, Math.PI / 6, 0));

    Transform camera = tree.transform("camera", "odom");

    assertPlace(camera, 9.9, 5.4, 1.1);
    assertThat(camera.pitch()).isCloseTo(Math.PI / 6, within(1e-12));
    assertThat(Math.abs(camera.yaw())).isCloseTo(Math.PI, within(1e-12));
    assertThat(camera.roll()).isCloseTo(0, within(1e-12));
  }

  @Test
  void goesDownAgainAndAcross() {
    tree.put("base_link", "odom", Transform.of(10, 5, 0, 0, 0, Math.PI / 2));
    tree.put("laser", "base_link", Transform.translation(0.3, 0, 0.5));
    tree.put("gps", "base_link", Transform.translation(-0.2, 0.1, 1));
    assertPlace(tree.transform("odom", "base_link"), -5, 10, 0);
    assertPlace(tree.transform("laser", "gps"), 0.5, -0.1, -0.5);
    assertPlace(tree.transform("laser", "laser"), 0, 0, 0);
  }

  @Test
  void followsAFrameThatMoves() {
    tree.put("camera", "base_link", Transform.translation(1, 0, 0));
    tree.put("camera", "base_link", Transform.translation(2, 0, 0));
    assertPlace(tree.transform("camera", "base_link"), 2, 0, 0);
  }

  @Test
  void refusesWhatCannotBe() {
    tree.put("b", "a", Transform.IDENTITY);
    tree.put("y", "x", Transform.IDENTITY);
    assertThatThrownBy(() -> tree.put("a", "b", Transform.IDENTITY))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("frame a cannot have the parent b, which is its descendant");
    assertThatThrownBy(() -> tree.transform("b", "y"))
        .hasMessage("nothing connects frame b (in a) and frame y (in x)");
    assertThatThrownBy(() -> tree.transform("q", "a"))
        .hasMessage("there is no frame q; there are [b, y]");
  }

  private static void assertPlace(Transform transform, double x, double y, double z) {
    assertThat(transform.x()).isCloseTo(x, within(1e-12));
    assertThat(transform.y()).isCloseTo(y, within(1e-12));
    assertThat(transform.z()).isCloseTo(z, within(1e-12));
  }
}
