package org.dfra.app.doctor;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
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
          "none of " + measured.robot() + "'s modules tells its clock",
          "See how they are: ./dfra module list.");
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
    String mend =
        "Have both follow one time server, with chrony say; on a field without a network let one"
            + " of the robots be it.";
    if (offset.atLeast().compareTo(FAIL_OFFSET) > 0) {
      return Finding.fail(subject(), what, mend);
    }
    return offset.atLeast().compareTo(WARN_OFFSET) > 0
        ? Finding.warn(subject(), what, mend)
        : Finding.ok(subject(), what);
  }
}
