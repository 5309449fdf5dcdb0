package org.dfra.behaviors.perceptual.team;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Objects;
import org.dfra.behaviors.SteppedTime;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.perceptual.Teammate;
import org.dfra.lifecycle.Incident;
import org.dfra.time.ClockOffset;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Two robots with clocks of their own drive towards each other and beyond, 0.7 m/s each. */
@Timeout(60)
class TeamTrackerTest {

  private static final double SPEED = 0.7;

  /** Clocks that gain a tenth of a millisecond in a second are poor ones. */
  private static final double DRIFT = 1e-4;

  /** What the offset is to be known within after a minute, seconds; at 1.4 m/s that is 5 cm. */
  private static final double BOUND = 0.035;

  private final SteppedTime truth = new SteppedTime();
  private final InMemoryModuleDirectory directory = new InMemoryModuleDirectory(truth);
  private final OwnTime behind = new OwnTime(truth, -0.3, 0);
  private final OwnTime ahead = new OwnTime(truth, 0.8, DRIFT);
  private List<Searcher> robots = List.of();

  @AfterEach
  void end() {
    robots.forEach(Searcher::close);
    directory.close();
  }

  private void begin(long seed) {
    Searcher first = new Searcher("atrv1", truth, behind, directory, seed, 0, SPEED);
    robots = List.of(first);
    Searcher second = new Searcher("atrv2", truth, ahead, directory, ~seed, 150, -SPEED);
    robots = List.of(first, second);
  }

  private static Teammate teammateOf(Searcher robot) {
    List<Teammate> teammates = robot.team.team().teammates();
    assertThat(teammates).hasSize(1);
    return teammates.get(0);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void findsClockOffsetsAndDistancesAtOneInstant(long seed) {
    begin(seed);
    truth.step(60);
    double naiveMost = 0;
    for (int i = 0; i < 400; i++) {
      truth.step(0.25);
      Teammate second = teammateOf(robots.get(0));
      ClockOffset clock = Objects.requireNonNull(second.clockOffset());
      double truly = ahead.ahead() - behind.ahead(); // 1.1 s and more
      assertThat(clock.uncertaintySeconds()).as("seed %d", seed).isLessThan(BOUND);
      assertThat(clock.seconds())
          .as("seed %d: %s", seed, clock)
          .isCloseTo(truly, within(clock.uncertaintySeconds()));

      Teammate.RelativePosition near = Objects.requireNonNull(second.relativePosition());
      // The instant, by the first robot's clock, is at most one step of its wheels ago.
      double age = (behind.instant().toEpochMilli() - near.time().toEpochMilli()) / 1e3;
      assertThat(age).isBetween(-0.001, 0.25);
      double separation = robots.get(1).east() - robots.get(0).east() + 2 * SPEED * age;
      // Both estimates are off by centimetres: their fixes have no error, the latencies have.
      assertThat(near.east())
          .as("seed %d, %.1f m apart", seed, separation)
          .isCloseTo(separation, within(0.12));
      assertThat(near.distance()).isCloseTo(Math.abs(separation), within(0.12));
      naiveMost = Math.max(naiveMost, Math.abs(naive() - separation));
    }
    assertThat(naiveMost)
        .as("error of comparing the poses as they are published")
        .isGreaterThan(0.6);
  }

  /** Metres east from the first to the second, where both say they are at the same reading. */
  private double naive() {
    PoseEstimate first = robots.get(0).position.estimate();
    PoseEstimate second = robots.get(1).position.estimate();
    double separation = second.east() - first.east();
    double seconds = (second.measured().toEpochMilli() - first.measured().toEpochMilli()) / 1e3;
    return separation
        + SPEED * seconds; // the second's pose, brought to the first's time as written
  }

  @Test
  void bothSayTheSameOfEachOther() {
    begin(7);
    truth.step(90);
    ClockOffset second = Objects.requireNonNull(teammateOf(robots.get(0)).clockOffset());
    ClockOffset first = Objects.requireNonNull(teammateOf(robots.get(1)).clockOffset());
    assertThat(second.seconds()).isCloseTo(-first.seconds(), within(1e-3));
    // One is of poses that are a cycle older than the other's, and clocks drift meanwhile.
    assertThat(second.uncertaintySeconds()).isCloseTo(first.uncertaintySeconds(), within(1e-3));
    Teammate.RelativePosition near =
        Objects.requireNonNull(teammateOf(robots.get(1)).relativePosition());
    assertThat(near.east()).as("150 m less what both have driven").isCloseTo(-24, within(0.3));
  }

  @Test
  void saysForHowLongTheOtherWasOutOfReach() {
    begin(1);
    truth.step(30);
    assertThat(teammateOf(robots.get(0)).isOutOfReach()).isFalse();
    assertThat(gaps()).isEmpty();
    robots.get(1).end(robots.get(1).position);
    truth.step(4);
    assertThat(teammateOf(robots.get(0)).isOutOfReach()).isTrue();
    assertThat(gaps()).singleElement().asString().startsWith("atrv2 is out of reach");
    truth.step(20);
    assertThat(gaps()).as("it says so once").hasSize(1);
    assertThat(teammateOf(robots.get(0)).relativePosition())
        .as("what was known stays known")
        .isNotNull();
  }

  private List<String> gaps() {
    return robots.get(0).team.history().recent().stream()
        .filter(each -> each.kind() == Incident.Kind.GAP)
        .map(Incident::description)
        .toList();
  }
}
