package org.dfra.sim.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import org.dfra.sim.physics.DrivetrainPhysics.Travel;
import org.junit.jupiter.api.Test;

class IdealDrivetrainTest {

  private static final Instant BEGIN = Instant.parse("2026-01-21T07:33:29Z");

  private final IdealDrivetrain wheels = new IdealDrivetrain(BEGIN);

  private static Instant at(double seconds) {
    return BEGIN.plusNanos(Math.round(seconds * 1e9));
  }

  @Test
  void getToTheirSpeedsEvenlyAndKeepThem() {
    wheels.drive(BEGIN, 1, -2, 0.5, 4);
    Travel rising = wheels.travel(at(1));
    assertThat(rising.speed()).isCloseTo(0.5, within(1e-12));
    assertThat(rising.distance()).isCloseTo(0.25, within(1e-12)); // half of 0.5 m/s² in 1 s
    assertThat(rising.yawRate()).isCloseTo(-2, within(1e-12)); // after half a second
    assertThat(rising.yaw()).isCloseTo(-0.5 - 1, within(1e-12));
    Travel steady = wheels.travel(at(5));
    assertThat(steady.speed()).isCloseTo(1, within(1e-12));
    assertThat(steady.distance()).isCloseTo(1 + 3, within(1e-12));
  }

  @Test
  void knowSinceWhenTheyStandWheneverTheyAreAsked() {
    assertThat(wheels.stoppedSince(at(0.5))).isEqualTo(BEGIN);
    wheels.drive(at(1), 1, 0, 100, 100);
    assertThat(wheels.stoppedSince(at(2))).isNull();
    wheels.drive(at(3), 0, 0, 5, 5);
    assertThat(wheels.stoppedSince(at(3.1))).isNull();
    // From 1 m/s to 1 mm/s by 5 m/s²
    assertThat(wheels.stoppedSince(at(9))).isEqualTo(at(3.1998));
    wheels.drive(at(10), 0, 0, 1, 1);
    assertThat(wheels.stoppedSince(at(11))).as("commanded to stop again").isEqualTo(at(3.1998));
    wheels.drive(at(12), 0, 0.5, 1, 1);
    wheels.drive(at(12.1), 0, 0, 1, 1);
    assertThat(wheels.stoppedSince(at(13))).isEqualTo(at(12.199));
  }

  @Test
  void areHeldByTheirBrakes() {
    wheels.drive(BEGIN, 1, 0, 100, 100);
    wheels.brake(at(1), true);
    assertThat(wheels.travel(at(1.05)).speed()).isZero();
    wheels.drive(at(2), 1, 1, 1, 1);
    assertThat(wheels.travel(at(3)).speed()).isZero();
    wheels.brake(at(3), false);
    assertThat(wheels.travel(at(4)).speed()).isZero();
    wheels.drive(at(4), 1, 1, 1, 1);
    assertThat(wheels.travel(at(4.5)).speed()).isCloseTo(0.5, within(1e-12));
  }

  @Test
  void doNotGoBackInTime() {
    wheels.drive(at(1), 1, 0, 1, 1);
    double before = wheels.travel(at(2)).distance();
    assertThat(wheels.travel(at(1.5)).distance()).isEqualTo(before);
    assertThatThrownBy(() -> wheels.drive(at(3), 1, 0, 0, 1))
        .hasMessage("accelerations 0.0 m/s² and 1.0 rad/s² must both be above 0");
  }
}
