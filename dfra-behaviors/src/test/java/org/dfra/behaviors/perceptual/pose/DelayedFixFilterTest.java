package org.dfra.behaviors.perceptual.pose;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import org.dfra.behaviors.perceptual.pose.FilterInput.LocalFix;
import org.dfra.behaviors.perceptual.pose.FilterInput.MotionIncrement;
import org.junit.jupiter.api.Test;

class DelayedFixFilterTest {

  private static final int STEPS = 200;

  private static MotionIncrement step(int i) {
    long from = i * EpochNanos.SECOND / 10;
    double turn = 0.02 * Math.sin(i / 9.0);
    return new MotionIncrement(
        from, from + EpochNanos.SECOND / 10, 0.06, turn, turn, 0, 0, MotionIncrement.Kind.MOTION);
  }

  private static LocalFix fix(Random random) {
    long time = (long) (random.nextDouble() * (STEPS / 10.0 - 0.001) * EpochNanos.SECOND);
    double seconds = EpochNanos.seconds(0, time);
    return new LocalFix(
        time,
        random.nextInt(2),
        false,
        0.6 * seconds + random.nextGaussian(),
        random.nextGaussian(),
        0.3,
        0,
        0.6,
        0.6,
        0.1 * random.nextGaussian());
  }

  private static DelayedFixFilter replay() {
    DelayedFixFilter replay = new DelayedFixFilter(TrackerSettings.DEFAULT);
    replay.head().initialize(0, 0, 0, 0);
    replay.head().setUncorrelated(Belief.EAST, 0, 2);
    replay.head().setUncorrelated(Belief.NORTH, 0, 2);
    replay.head().setUncorrelated(Belief.YAW, 0, 0.2);
    replay.rebase();
    return replay;
  }

  private static DelayedFixFilter run(List<LocalFix> fixes, Random late) {
    DelayedFixFilter replay = replay();
    record Due(LocalFix fix, double at) {}
    List<Due> dues = new ArrayList<>();
    for (LocalFix fix : fixes) {
      dues.add(new Due(fix, EpochNanos.seconds(0, fix.time()) + 0.1 + 2.5 * late.nextDouble()));
    }
    dues.sort(Comparator.comparingDouble(Due::at));
    int next = 0;
    for (int i = 0; i < STEPS; i++) {
      replay.add(step(i));
      while (next < dues.size() && (dues.get(next).at <= (i + 1) / 10.0 || i == STEPS - 1)) {
        DelayedFixFilter.FixOutcome unused = replay.add(dues.get(next++).fix);
      }
    }
    return replay;
  }

  @Test
  void lateAndDisorderedFixesCountAsIfTheyHadCome() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    List<LocalFix> fixes = new ArrayList<>();
    for (int i = 0; i < 40; i++) {
      fixes.add(fix(random));
    }
    Belief one = run(fixes, new Random(random.nextLong())).head();
    Belief other = run(fixes, new Random(random.nextLong())).head();
    for (int i = 0; i < Belief.SIZE; i++) {
      assertThat(one.get(i)).as("-Ddfra.seed=%d", seed).isCloseTo(other.get(i), within(1e-9));
      assertThat(one.variance(i)).isCloseTo(other.variance(i), within(1e-9));
    }
  }

  @Test
  void aLateFixIsNotTakenForAFreshOne() {
    DelayedFixFilter replay = replay();
    for (int i = 0; i < 20; i++) {
      replay.add(step(i));
    }
    double east = replay.head().get(Belief.EAST);
    double north = replay.head().get(Belief.NORTH);
    // Exactly where the robot was one second ago.
    DelayedFixFilter past = replay();
    for (int i = 0; i < 10; i++) {
      past.add(step(i));
    }
    Belief then = past.head();
    double cos = Math.cos(then.get(Belief.YAW));
    double sin = Math.sin(then.get(Belief.YAW));
    LocalFix fix =
        new LocalFix(
            EpochNanos.SECOND,
            0,
            false,
            then.get(Belief.EAST) + 0.3 * cos,
            then.get(Belief.NORTH) + 0.3 * sin,
            0.3,
            0,
            0.6,
            0,
            Double.NaN);
    assertThat(replay.add(fix)).isEqualTo(DelayedFixFilter.FixOutcome.USED);
    assertThat(replay.head().get(Belief.EAST)).isCloseTo(east, within(1e-9));
    assertThat(replay.head().get(Belief.NORTH)).isCloseTo(north, within(1e-9));
    assertThat(replay.head().variance(Belief.EAST)).isLessThan(4);
  }

  @Test
  void refusesWhatIsOlderThanItsHorizon() {
    DelayedFixFilter replay = replay();
    for (int i = 0; i < 60; i++) {
      replay.add(step(i));
    }
    double east = replay.head().get(Belief.EAST);
    LocalFix old = new LocalFix(EpochNanos.SECOND, 0, false, 5, 5, 0, 0, 0.6, 0, Double.NaN);
    assertThat(replay.add(old)).isEqualTo(DelayedFixFilter.FixOutcome.TOO_LATE);
    assertThat(replay.head().get(Belief.EAST)).isEqualTo(east);
  }

  @Test
  void aStepCutInTwoMovesAsFarAndIsAsUncertain() {
    Belief whole = replay().head();
    Belief halves = replay().head();
    MotionIncrement step = step(3);
    whole.predict(step);
    long at = step.from() + EpochNanos.SECOND / 30;
    halves.predict(step.before(at));
    halves.predict(step.after(at));
    for (int i = 0; i < Belief.SIZE; i++) {
      // The chord's direction is that of its middle: unequal by the square of a small turn.
      assertThat(halves.get(i)).isCloseTo(whole.get(i), within(1e-5));
      assertThat(halves.variance(i)).isCloseTo(whole.variance(i), within(1e-5));
    }
  }
}
