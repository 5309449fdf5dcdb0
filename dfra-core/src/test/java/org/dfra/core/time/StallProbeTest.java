package org.dfra.core.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import org.dfra.core.time.Timing.BoundResult;
import org.junit.jupiter.api.Test;

class StallProbeTest {

  private static final Duration BOUND = Duration.ofSeconds(5);

  private final AtomicLong now = new AtomicLong(1_000_000_000L);
  private final AtomicReference<Double> load = new AtomicReference<>(0.5);
  private final AtomicReference<ProcessorTimes> processors =
      new AtomicReference<>(new ProcessorTimes(7000, 90));
  private final StallProbe probe = new StallProbe(now::get, load::get, processors::get);

  private void measureFor(Duration time) {
    for (long i = 0; i < time.dividedBy(StallProbe.PERIOD); i++) {
      pass(StallProbe.PERIOD);
      probe.measure();
    }
  }

  private void pass(Duration time) {
    now.addAndGet(time.toNanos());
  }

  @Test
  void timeOnAComputerThatRunsItsProgramsIsTheProgramsOwn() {
    StallProbe.Stopwatch watch = probe.stopwatch();
    measureFor(Duration.ofSeconds(6));
    Timing timing = watch.stop();
    assertThat(timing).isEqualTo(new Timing(Duration.ofSeconds(6), Duration.ZERO, 0.5));
    assertThat(timing.compareWith(BOUND)).isEqualTo(BoundResult.MISSED);
    assertThat(timing.compareWith(Duration.ofSeconds(6))).isEqualTo(BoundResult.MET);
    assertThatThrownBy(() -> timing.requireWithin("listening again", BOUND))
        .isInstanceOf(AssertionError.class)
        .hasMessage(
            "listening again took 6.000 s, bound 5.000 s; the computer stalled for 0.000 s of it,"
                + " with 0.5 runnable threads per processor");
  }

  @Test
  void aStallExplainsAMissThatIsNoLongerThanIt() {
    StallProbe.Stopwatch watch = probe.stopwatch();
    measureFor(Duration.ofSeconds(4));
    pass(Duration.ofSeconds(2));
    probe.measure();
    Timing timing = watch.stop();
    assertThat(timing.took()).isEqualTo(Duration.ofSeconds(6));
    assertThat(timing.stalled()).isEqualTo(Duration.ofMillis(1980));
    assertThat(timing.compareWith(BOUND)).isEqualTo(BoundResult.MISSED_DURING_A_STALL);
    assertThat(timing.compareWith(Duration.ofSeconds(3))).isEqualTo(BoundResult.MISSED);
  }

  @Test
  void aStallIsSeenAlsoByAProgramThatWakesBeforeTheProbe() {
    measureFor(Duration.ofSeconds(1));
    StallProbe.Stopwatch watch = probe.stopwatch();
    pass(Duration.ofSeconds(6));
    assertThat(watch.stop().stalled()).isEqualTo(Duration.ofMillis(5980));
    StallProbe.Stopwatch after = probe.stopwatch();
    probe.measure();
    assertThat(after.stop().stalled()).as("counted once").isZero();
  }

  @Test
  void anOverloadExplainsAMissByItsRatio() {
    load.set(3.0);
    StallProbe.Stopwatch watch = probe.stopwatch();
    measureFor(Duration.ofSeconds(12));
    Timing timing = watch.stop();
    assertThat(timing.compareWith(Duration.ofSeconds(4)))
        .isEqualTo(BoundResult.MISSED_DURING_AN_OVERLOAD);
    assertThat(timing.compareWith(Duration.ofSeconds(3))).isEqualTo(BoundResult.MISSED);
  }

  /** The tests beside it may be the load; a stall is never theirs. */
  @Test
  void anOverloadExcusesNothingWhereTheTestIsNotRepeated() {
    Timing overloaded = new Timing(Duration.ofSeconds(6), Duration.ZERO, 3);
    assertThat(output(overloaded, true))
        .startsWith("MISSED DURING AN OVERLOAD: listening again took 6.000 s, bound 5.000 s;");
    assertThatThrownBy(() -> output(overloaded, false))
        .isInstanceOf(AssertionError.class)
        .hasMessageStartingWith("listening again took 6.000 s, bound 5.000 s;");
    Timing stalled = new Timing(Duration.ofSeconds(6), Duration.ofSeconds(2), 3);
    assertThat(output(stalled, false)).startsWith("MISSED DURING A STALL: listening again took");
    Timing both = new Timing(Duration.ofSeconds(9), Duration.ofSeconds(2), 3);
    assertThat(both.compareWith(BOUND)).isEqualTo(BoundResult.MISSED_DURING_AN_OVERLOAD);
    assertThatThrownBy(() -> output(both, false)).isInstanceOf(AssertionError.class);
  }

  @Test
  void whatIsNotToHappenMayHappenOncePerStallThatExplainsIt() {
    Duration each = Duration.ofSeconds(1);
    Timing idle = new Timing(Duration.ofSeconds(60), Duration.ZERO, 0.5);
    assertThat(idle.compareWith(0, each)).isEqualTo(BoundResult.MET);
    assertThat(idle.compareWith(1, each)).isEqualTo(BoundResult.MISSED);
    assertThatThrownBy(() -> idle.requireNone("lost links", 1, each))
        .isInstanceOf(AssertionError.class)
        .hasMessageStartingWith("lost links: 1, where only each stall of 1.000 s explains one;");
    Timing stalled = new Timing(Duration.ofSeconds(60), Duration.ofMillis(2900), 0.5);
    assertThat(stalled.compareWith(2, each)).isEqualTo(BoundResult.MISSED_DURING_A_STALL);
    assertThat(stalled.compareWith(3, each)).isEqualTo(BoundResult.MISSED);
    Timing overloaded = new Timing(Duration.ofSeconds(60), Duration.ofMillis(2900), 2.5);
    assertThat(overloaded.compareWith(3, each)).isEqualTo(BoundResult.MISSED_DURING_AN_OVERLOAD);
    assertThat(overloaded.compareWith(38, each)).isEqualTo(BoundResult.MISSED_DURING_AN_OVERLOAD);
    assertThat(overloaded.compareWith(39, each))
        .as("36 s of waiting")
        .isEqualTo(BoundResult.MISSED);
  }

  /** What it prints; not to the console, or ./dfra test would repeat this test. */
  private static String output(Timing timing, boolean repeats) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    timing.requireWithin("listening again", BOUND, repeats, new PrintStream(out));
    return out.toString();
  }

  /**
   * Else a bound of some tenths of a second would fail by a stall that is seen, and not counted.
   */
  @Test
  void aStallOfATenthOfTheBoundCounts() {
    Duration bound = Duration.ofMillis(350);
    Timing timing = new Timing(Duration.ofMillis(370), Duration.ofMillis(36), 0.5);
    assertThat(timing.compareWith(bound)).isEqualTo(BoundResult.MISSED_DURING_A_STALL);
    Timing quick = new Timing(Duration.ofMillis(370), Duration.ofMillis(30), 0.5);
    assertThat(quick.compareWith(bound)).isEqualTo(BoundResult.MISSED);
    Timing patient = new Timing(Duration.ofMillis(5050), Duration.ofMillis(90), 0.5);
    assertThat(patient.compareWith(BOUND)).as("less than 0.1 s").isEqualTo(BoundResult.MISSED);
  }

  @Test
  void timersThatAreLateByMillisecondsAreNoStall() {
    StallProbe.Stopwatch watch = probe.stopwatch();
    for (int i = 0; i < 100; i++) {
      pass(StallProbe.PERIOD.plusMillis(4));
      probe.measure();
    }
    assertThat(watch.stop().stalled()).isZero();
  }

  private void run(long served, long stolen) {
    processors.updateAndGet(
        all -> new ProcessorTimes(all.busyTicks() + served, all.stealTicks() + stolen));
  }

  @Test
  void whatTheHostGivesToOthersExplainsAMissLikeAStall() {
    StallProbe.Stopwatch watch = probe.stopwatch();
    for (int i = 0; i < 300; i++) {
      run(3, 1);
      measureFor(StallProbe.PERIOD);
    }
    Timing timing = watch.stop();
    Duration stolen = Duration.ofMillis(1500); // a quarter of what was wanted
    assertThat(timing).isEqualTo(new Timing(Duration.ofSeconds(6), Duration.ZERO, 0.5, stolen));
    assertThat(timing.compareWith(BOUND)).as("4.5 s").isEqualTo(BoundResult.MISSED_DURING_A_STALL);
    assertThat(timing.compareWith(Duration.ofSeconds(4))).isEqualTo(BoundResult.MISSED);
    assertThatThrownBy(() -> timing.requireWithin("listening again", Duration.ofSeconds(4)))
        .hasMessageEndingWith(
            " 0.5 runnable threads per processor; its host gave 1.500 s of it to others");
    Timing part = timing.ofPart(Duration.ofSeconds(2));
    assertThat(part.stolen()).isEqualTo(Duration.ofMillis(500));
    assertThat(part.compareWith(Duration.ofMillis(1600)))
        .isEqualTo(BoundResult.MISSED_DURING_A_STALL);
    assertThat(part.compareWith(Duration.ofMillis(1400))).isEqualTo(BoundResult.MISSED);
    measureFor(Duration.ofSeconds(4)); // it wants no processor
    run(300, 20);
    measureFor(Duration.ofSeconds(2));
    Duration both = Duration.ofSeconds(2);
    assertThat(probe.past(both, both).stolen()).isEqualTo(Duration.ofMillis(125));
    assertThat(probe.past(Duration.ofSeconds(12), Duration.ofSeconds(6)).stolen())
        .isCloseTo(stolen, Duration.ofMillis(10));
  }

  /** The wheels stand late by themselves; a hundredth of a second was taken from them. */
  @Test
  void whatWasStolenFromAComputerThatHadLittleToDoIsNoMoreThanThat() {
    StallProbe.Stopwatch watch = probe.stopwatch();
    measureFor(Duration.ofMillis(660));
    run(3, 1);
    Timing timing = watch.stop();
    assertThat(timing.stolen()).isEqualTo(Duration.ofMillis(10));
    assertThat(timing.compareWith(Duration.ofMillis(500))).isEqualTo(BoundResult.MISSED);
    assertThat(timing.steal()).isEmpty();
  }

  @Test
  void aStallInWhichTheHostWasAwayIsCountedOnce() {
    Duration second = Duration.ofSeconds(1);
    Timing timing = new Timing(Duration.ofSeconds(7), second, 0.5, second);
    assertThat(timing.compareWith(Duration.ofSeconds(6)))
        .isEqualTo(BoundResult.MISSED_DURING_A_STALL);
    assertThat(timing.compareWith(Duration.ofMillis(5900))).isEqualTo(BoundResult.MISSED);
  }

  @Test
  void readsWhatLinuxCounts() {
    Duration second = Duration.ofSeconds(1);
    ProcessorTimes before = ProcessorTimes.of("cpu  1000 10 200 5000 60 7 13 40 0 0");
    assertThat(before).isEqualTo(new ProcessorTimes(1230, 40));
    ProcessorTimes after = ProcessorTimes.of("cpu  1040 10 210 9000 60 7 23 60 0 0");
    assertThat(after.stolenSince(before, second)).as("20 of 80").isEqualTo(Duration.ofMillis(200));
    assertThat(before.stolenSince(before, second)).isZero();
    assertThat(ProcessorTimes.of("")).isEqualTo(ProcessorTimes.UNKNOWN);
    assertThat(ProcessorTimes.of("cpu 1 2 3 4")).isEqualTo(ProcessorTimes.UNKNOWN);
  }

  /** Four seconds, a stall of 1.98 s, four seconds; and what was asked for is long over. */
  @Test
  void seesWhatWasMeasuredInASpanThatIsOver() {
    measureFor(Duration.ofSeconds(4));
    load.set(3.0);
    pass(Duration.ofSeconds(2));
    probe.measure();
    load.set(1.5);
    measureFor(Duration.ofSeconds(4));
    Duration second = Duration.ofSeconds(1);
    assertThat(probe.past(Duration.ofSeconds(6), second).stalled())
        .as("the first half of the stall, and no more")
        .isEqualTo(Duration.ofMillis(980));
    assertThat(probe.past(Duration.ofMillis(5500), second).stalled()).isEqualTo(second);
    assertThat(probe.past(Duration.ofMillis(4500), second))
        .isEqualTo(new Timing(second, Duration.ofMillis(500), (3 + 26 * 1.5) / 27));
    assertThat(probe.past(Duration.ofSeconds(3), second))
        .isEqualTo(new Timing(second, Duration.ZERO, 1.5));
    assertThat(probe.past(Duration.ofSeconds(9), second))
        .isEqualTo(new Timing(second, Duration.ZERO, 0.5));
    pass(Duration.ofSeconds(2));
    assertThat(probe.past(second, second).stalled()).as("under way").isEqualTo(second);
    assertThatThrownBy(() -> probe.past(Duration.ofDays(1), second))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("began PT24H ago");
  }

  @Test
  void measuresThisComputer() throws InterruptedException {
    try (StallProbe real = StallProbe.start()) {
      StallProbe.Stopwatch watch = real.stopwatch();
      Timing timing = watch.stop();
      while (timing.took().compareTo(StallProbe.PERIOD.multipliedBy(5)) < 0) {
        Thread.onSpinWait();
        timing = watch.stop();
      }
      assertThat(timing.load()).as("this thread runs").isPositive();
      assertThat(timing.stalled()).isLessThan(timing.took());
    }
  }
}
