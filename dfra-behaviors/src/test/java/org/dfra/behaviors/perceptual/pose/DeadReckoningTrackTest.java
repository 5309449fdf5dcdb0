package org.dfra.behaviors.perceptual.pose;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.dfra.behaviors.perceptual.pose.FilterInput.MotionIncrement;
import org.dfra.behaviors.perceptual.pose.TrackerSettings.GyroErrors;
import org.junit.jupiter.api.Test;

class DeadReckoningTrackTest {

  private final DeadReckoningTrack track = new DeadReckoningTrack(GyroErrors.DEFAULT);
  private long now;

  /** The wheels do not move for a second, and the gyro shows that rate, in radians per second. */
  private void addStationarySecond(double rate) {
    long then = now + EpochNanos.SECOND;
    track.add(
        new MotionIncrement(now, then, 0, 0, rate, 0, 0, MotionIncrement.Kind.STATIONARY_WHEELS));
    now = then;
  }

  @Test
  void itFollowsAnErrorThatDriftsFarFromWhereItBegan() {
    track.begin(0);
    for (int second = 0; second < 600; second++) {
      addStationarySecond(1e-4 * second);
    }
    assertThat(track.gyroBias()).isCloseTo(0.06, within(0.01)); // it lags by a minute
    assertThat(track.end().yaw()).isZero();
  }

  @Test
  void oneThatIsTurnedByHandTurns() {
    track.begin(0);
    addStationarySecond(0.001);
    for (int second = 0; second < 10; second++) {
      addStationarySecond(0.25);
    }
    assertThat(track.gyroBias()).isEqualTo(0.001);
    assertThat(track.end().yaw()).isCloseTo(2.49, within(1e-9));
  }
}
