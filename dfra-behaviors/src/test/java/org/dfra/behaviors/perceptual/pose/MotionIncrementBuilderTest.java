package org.dfra.behaviors.perceptual.pose;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.dfra.behaviors.perceptual.pose.FilterInput.MotionIncrement;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.Odometry;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class MotionIncrementBuilderTest {

  private final MotionIncrementBuilder steps =
      new MotionIncrementBuilder(TrackerSettings.WheelErrors.DEFAULT);

  private @Nullable MotionIncrement wheels(
      double t, double x, double y, double yaw, double v, double w) {
    return steps.take(new Odometry(Field.utc(t), "o", "b", x, y, yaw, v, w));
  }

  private void gyro(double t, double rate) {
    steps.take(new AngularRate(Field.utc(t), "g", rate));
  }

  @Test
  void takesDifferencesAlongTheWheelsOwnYaw() {
    assertThat(wheels(0, 5, 7, Math.PI / 2, 0.5, 0)).isNull();
    MotionIncrement step = wheels(0.1, 5, 6.95, Math.PI / 2, -0.5, 0);
    assertThat(step).isNotNull();
    assertThat(step.distance()).isCloseTo(-0.05, within(1e-12));
    assertThat(step.wheelYaw()).isZero();
    assertThat(step.hasGyro()).isFalse();
    assertThat(step.seconds()).isCloseTo(0.1, within(1e-12));
  }

  @Test
  void passesOverWhatIsRepeatedOrOld() {
    wheels(0, 0, 0, 0, 0.5, 0);
    wheels(0.1, 0.05, 0, 0, 0.5, 0);
    assertThat(wheels(0.1, 0.05, 0, 0, 0.5, 0)).isNull();
    assertThat(wheels(0.05, 0.02, 0, 0, 0.5, 0)).isNull();
    MotionIncrement step = wheels(0.2, 0.1, 0, 0, 0.5, 0);
    assertThat(step).isNotNull();
    assertThat(step.distance()).isCloseTo(0.05, within(1e-12));
  }

  @Test
  void goesBySpeedWhereThePoseJumps() {
    wheels(0, 80, 10, 1, 0.5, 0.2);
    MotionIncrement step = wheels(0.1, 0, 0, 0, 0.5, 0.2);
    assertThat(step).isNotNull();
    assertThat(step.distance()).isCloseTo(0.05, within(1e-12));
    assertThat(step.wheelYaw()).isCloseTo(0.02, within(1e-12));
    assertThat(step.distanceSigma()).as("no farther than it can go: 3 m/s").isBetween(0.01, 0.31);
  }

  @Test
  void bridgesASilenceOfWheelsByWhatTheyCountedMeanwhile() {
    wheels(0, 0, 0, 0, 0.5, 0);
    MotionIncrement step = wheels(3, 1.5, 0, 0, 0.5, 0);
    assertThat(step).isNotNull();
    assertThat(step.distance()).isCloseTo(1.5, within(1e-12));
    assertThat(step.distanceSigma()).isGreaterThan(0.1);
  }

  @Test
  void isBlindAcrossALongSilenceAndBelievesItOnlyTheSecondTime() {
    wheels(0, 0, 0, 0, 0.5, 0);
    assertThat(wheels(60, 9, 0, 0, 0.5, 0)).isNull();
    MotionIncrement step = wheels(60.1, 9.05, 0, 0, 0.5, 0);
    assertThat(step).isNotNull();
    assertThat(step.distance()).isZero();
    assertThat(step.isClockJump()).isFalse();
    assertThat(step.distanceSigma()).isGreaterThan(10);
  }

  @Test
  void noticesAClockThatIsSetBack() {
    wheels(100, 0, 0, 0, 0.5, 0);
    assertThat(wheels(10, 0.05, 0, 0, 0.5, 0)).isNull();
    MotionIncrement step = wheels(10.1, 0.1, 0, 0, 0.5, 0);
    assertThat(step).isNotNull();
    assertThat(step.isClockJump()).isTrue();
  }

  @Test
  void oneReadingFromTheFutureDoesNoHarm() {
    wheels(0, 0, 0, 0, 0.5, 0);
    assertThat(wheels(1e6, 0, 0, 0, 0.5, 0)).isNull();
    MotionIncrement step = wheels(0.1, 0.05, 0, 0, 0.5, 0);
    assertThat(step).isNotNull();
    assertThat(step.distance()).isCloseTo(0.05, within(1e-12));
  }

  @Test
  void aGyroThatIsLateIsMadeUpForByTheNextStep() {
    gyro(0, 0);
    wheels(0, 0, 0, 0, 0, 0);
    MotionIncrement first = wheels(0.1, 0, 0, 0, 0, 0); // does not know yet that it turns
    gyro(0.1, 1);
    gyro(0.2, 1);
    MotionIncrement second = wheels(0.2, 0, 0, 0, 0, 0);
    assertThat(first).isNotNull();
    assertThat(second).isNotNull();
    assertThat(first.gyroYaw()).isZero();
    assertThat(first.gyroYaw() + second.gyroYaw()).isCloseTo(0.15, within(1e-9));
  }

  @Test
  void aGyroThatIsSilentContributesNothing() {
    gyro(0, 0.5);
    wheels(0, 0, 0, 0, 0, 0);
    MotionIncrement step = wheels(1, 0, 0, 0.4, 0, 0.4);
    assertThat(step).isNotNull();
    assertThat(step.hasGyro()).isFalse();
    gyro(1.5, 0.5);
    MotionIncrement across = wheels(1.6, 0, 0, 0.6, 0, 0.4);
    assertThat(across).isNotNull();
    assertThat(across.hasGyro()).as("its angle before the silence is of no use").isFalse();
    gyro(1.7, 0.5);
    MotionIncrement again = wheels(1.7, 0, 0, 0.65, 0, 0.4);
    assertThat(again).isNotNull();
    assertThat(again.gyroYaw()).isCloseTo(0.05, within(1e-9));
  }

  @Test
  void restsOnlyAfterHalfASecondOfStillness() {
    boolean rested = false;
    for (int i = 0; i <= 10; i++) {
      MotionIncrement step = wheels(i / 10.0, 1, 2, 3, 0, 0);
      rested = step != null && step.areWheelsStationary();
      assertThat(rested).as("after %d steps", i).isEqualTo(i > 5);
    }
    MotionIncrement moving = wheels(1.1, 1 - 0.05, 2, 3, 0.5, 0);
    assertThat(moving).isNotNull();
    assertThat(moving.areWheelsStationary()).isFalse();
  }
}
