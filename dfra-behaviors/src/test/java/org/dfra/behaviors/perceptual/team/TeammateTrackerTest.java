package org.dfra.behaviors.perceptual.team;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.perceptual.Teammate;
import org.dfra.geometry.GeoPosition;
import org.dfra.time.ClockOffset;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** What is reported of another robot that falls silent and is received again. */
class TeammateTrackerTest {

  private static final Instant BEGIN = Instant.parse("2026-11-21T12:00:00Z");
  private static final long LONGEST = 3_000_000_000L;

  private final TeammateTracker teammate = new TeammateTracker("atrv2");

  private Optional<String> receive(double seconds, long number) {
    Instant now = BEGIN.plusNanos(Math.round(seconds * 1e9));
    PoseEstimate pose = pose(seconds, 0, null);
    return teammate.receive(pose, number, now, Math.round(seconds * 1e9), LONGEST);
  }

  private Optional<String> look(double seconds) {
    return teammate.checkSilence(Math.round(seconds * 1e9), LONGEST);
  }

  private Teammate known() {
    return teammate.relativeTo(new OwnPoseBuffer());
  }

  private static PoseEstimate pose(double seconds, double east, @Nullable ClockOffset clock) {
    return new PoseEstimate(
        BEGIN.plusNanos(Math.round(seconds * 1e9)),
        "r/map",
        new GeoPosition(48, 11, 0),
        east,
        0,
        0,
        0,
        0,
        0.3,
        0.1,
        null,
        clock);
  }

  @Test
  void withoutSatellitesTheOffsetIsUnknownAndSoIsThePosition() {
    ClockOffset some = new ClockOffset(Duration.ofMillis(800), Duration.ofMillis(10));
    OwnPoseBuffer own = new OwnPoseBuffer();
    own.add(pose(0, 0, some));
    own.add(pose(1, 1, some));
    assertThat(receive(0.5, 1)).as("its poses carry no offset").isEmpty();
    assertThat(teammate.relativeTo(own).clockOffset()).isNull();
    assertThat(teammate.relativeTo(own).relativePosition()).isNull();
    assertThat(teammate.relativeTo(own).lastReceived()).isEqualTo(BEGIN.plusMillis(500));

    OwnPoseBuffer without = new OwnPoseBuffer();
    without.add(pose(0, 0, null));
    Optional<String> unused = teammate.receive(pose(0.6, 7, some), 2, BEGIN, 600_000_000, LONGEST);
    assertThat(teammate.relativeTo(without).clockOffset()).isNull();
  }

  @Test
  void comparesPlacesOfOneInstantWhateverTheClocksShow() {
    OwnPoseBuffer own = new OwnPoseBuffer(); // 1 m/s to the east, its clock 0.2 s behind
    ClockOffset mine = new ClockOffset(Duration.ofMillis(-200), Duration.ofMillis(10));
    own.add(pose(9, 9.2, mine));
    own.add(pose(10, 10.2, mine));
    ClockOffset its = new ClockOffset(Duration.ofMillis(800), Duration.ofMillis(20));
    // It was 30 m east when its clock showed 10.5: that is 9.7 UTC and 9.5 of this robot.
    Optional<String> unused = teammate.receive(pose(10.5, 30, its), 1, BEGIN, 0, LONGEST);
    Teammate seen = teammate.relativeTo(own);
    assertThat(seen.clockOffset())
        .isEqualTo(new ClockOffset(Duration.ofSeconds(1), Duration.ofMillis(30)));
    assertThat(seen.relativePosition().time()).isEqualTo(BEGIN.plusMillis(9500));
    assertThat(seen.relativePosition().east()).isCloseTo(30 - 9.7, within(1e-6));
    assertThat(seen.relativePosition().sigma()).isCloseTo(0.3 * Math.sqrt(2), within(1e-9));
  }

  @Test
  void reportsTheGapWhenItIsOver() {
    assertThat(receive(0, 100)).isEmpty();
    assertThat(receive(0.1, 101)).isEmpty();
    assertThat(look(3)).isEmpty();
    assertThat(look(3.2)).contains("atrv2 is out of reach: no message from it for 3 s");
    assertThat(look(40)).as("once").isEmpty();
    assertThat(known().isOutOfReach()).isTrue();
    assertThat(receive(61.1, 711)).contains("atrv2 was out of reach for 61 s, 609 readings missed");
    assertThat(known().isOutOfReach()).isFalse();
    assertThat(known().missedReadings()).isEqualTo(609);
    assertThat(look(62)).isEmpty();
  }

  @Test
  void countsWhatWasMissedWithoutASilence() {
    assertThat(receive(0, 1)).isEmpty();
    assertThat(receive(0.5, 6)).isEmpty();
    assertThat(known().missedReadings()).isEqualTo(4);
  }

  @Test
  void whatWasPublishedBeforeItSubscribedIsNotMissed() {
    assertThat(receive(100, 5000)).isEmpty();
    assertThat(known().missedReadings()).isZero();
  }
}
