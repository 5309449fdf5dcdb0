package org.dfra.cli.doctor;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.dfra.cli.doctor.CheckRunner.Check;
import org.dfra.core.host.CommandName;
import org.jspecify.annotations.Nullable;

/** Checks the offsets between the robots' clocks and this computer's. */
final class ClockCheck implements Check {

  /** A robot moves about 10 cm in this time: others then see its reports at the wrong place. */
  private static final Duration WARN_OFFSET = Duration.ofMillis(100);

  /** The drive treats a command older than this as a stop. */
  private static final Duration FAIL_OFFSET = Duration.ofMillis(500);

  /**
   * A robot's clock.
   *
   * @param robot its name
   * @param offset the measured offset; null if none of its modules answered
   */
  record RobotClock(String robot, @Nullable NtpClockOffset offset) {}

  /** Measures the clocks of all discovered robots. */
  interface ClockProbe {
    List<RobotClock> measure() throws InterruptedException;
  }

  private final ClockProbe clocks;

  ClockCheck(ClockProbe clocks) {
    this.clocks = clocks;
  }

  @Override
  public Subject subject() {
    return Subject.CLOCK;
  }

  @Override
  public List<Finding> run() throws InterruptedException {
    List<Finding> findings = new ArrayList<>();
    for (RobotClock each : clocks.measure()) {
      findings.add(of(each));
    }
    return findings;
  }

  private Finding of(RobotClock measured) {
    @Nullable NtpClockOffset offset = measured.offset();
    if (offset == null) {
      return Finding.warn(
          subject(),
          "none of " + measured.robot() + "'s modules reports its clock",
          "See how they are: " + CommandName.current() + " module list.");
    }
    if (offset.atLeast().isZero()) {
      return Finding.ok(
          subject(),
          measured.robot()
              + "'s clock agrees with this computer's, ± "
              + DurationText.of(offset.uncertainty()));
    }
    String what =
        measured.robot()
            + "'s clock is "
            + DurationText.of(offset.offset().abs())
            + (offset.offset().isNegative() ? " behind" : " ahead of")
            + " this computer's, ± "
            + DurationText.of(offset.uncertainty());
    String remedy =
        "Synchronize both with one time server, for example by chrony; on a field without a"
            + " network it can be one of the robots.";
    if (offset.atLeast().compareTo(FAIL_OFFSET) > 0) {
      return Finding.fail(subject(), what, remedy);
    }
    return offset.atLeast().compareTo(WARN_OFFSET) > 0
        ? Finding.warn(subject(), what, remedy)
        : Finding.ok(subject(), what);
  }

  /**
   * The offset between another clock and this computer's, measured as by NTP (RFC 5905, section 8):
   * of several requests the one with the shortest round trip counts, and its time stamp is taken to
   * be from the middle of the round trip.
   *
   * @param offset positive if the other clock is ahead
   * @param uncertainty half the round trip: the maximum error of the offset
   */
  record NtpClockOffset(Duration offset, Duration uncertainty) {

    /** Lower bound of the absolute offset. */
    Duration atLeast() {
      Duration least = offset.abs().minus(uncertainty);
      return least.isNegative() ? Duration.ZERO : least;
    }

    /**
     * Queries another clock.
     *
     * @param times number of requests, at least 1
     * @param other returns the time there
     * @param here this computer's clock
     * @throws Exception thrown by the other clock
     */
    static NtpClockOffset measure(int times, Callable<Instant> other, InstantSource here)
        throws Exception {
      Optional<NtpClockOffset> best = Optional.empty();
      for (int i = 0; i < times; i++) {
        Instant asked = here.instant();
        Instant reported = other.call();
        Duration half = Duration.between(asked, here.instant()).dividedBy(2);
        NtpClockOffset offset =
            new NtpClockOffset(Duration.between(asked.plus(half), reported), half);
        if (best.isEmpty() || half.compareTo(best.get().uncertainty()) < 0) {
          best = Optional.of(offset);
        }
      }
      return best.orElseThrow(() -> new IllegalArgumentException("asked " + times + " times"));
    }
  }
}
