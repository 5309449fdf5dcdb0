package org.dfra.cli.event;

import java.time.Duration;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.Spec.Target;

/** Which events a command subscribes to, and for how long. A picocli mix-in. */
final class ListeningOptions {

  private static final double LONGEST_SECONDS = 1e9; // 30 years, and no overflow in nanoseconds

  @Option(
      names = "--kind",
      paramLabel = "KIND[,...]",
      hideParamSyntax = true,
      split = ",",
      description = "Only these kinds of events: ${COMPLETION-CANDIDATES}.")
  private EventKind @Nullable [] kinds;

  @Option(names = "--count", paramLabel = "N", description = "End after N events.")
  private long count = Long.MAX_VALUE;

  @Option(names = "--for", paramLabel = "SECONDS", description = "End after this time.")
  private double seconds = LONGEST_SECONDS;

  @Spec(Target.MIXEE)
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandSpec spec;

  /** Number of events after which the command ends. */
  long count() {
    if (count < 1) {
      throw wrong("--count=" + count + " is not 1 or more");
    }
    return count;
  }

  /** Time after which the command ends. */
  Duration time() {
    if (!(seconds > 0 && seconds <= LONGEST_SECONDS)) {
      throw wrong("--for=" + seconds + " is not a number of seconds above 0");
    }
    return Duration.ofNanos((long) (seconds * 1e9));
  }

  /**
   * The listener's delivery policy.
   *
   * @param defaultKinds the kinds of events if the user has named none
   */
  DeliveryPolicy policy(Set<EventKind> defaultKinds, int depth, double highestRate) {
    Set<EventKind> wanted = kinds == null ? defaultKinds : EnumSet.copyOf(List.of(kinds));
    try {
      return new DeliveryPolicy(wanted, depth, highestRate);
    } catch (IllegalArgumentException e) {
      throw wrong(String.valueOf(e.getMessage()));
    }
  }

  private ParameterException wrong(String sentence) {
    return new ParameterException(spec.commandLine(), sentence);
  }
}
