package org.dfra.app;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.core.time.Timing;
import org.dfra.core.time.Timing.BoundResult;
import org.jspecify.annotations.Nullable;

/**
 * The figures with a target that a demonstration printed under "Measured", and what the missed
 * times among them are worth.
 *
 * <p>The demonstration measures in a process of its own, so nobody knows during which of its times
 * the computer stalled or was overloaded. What a probe in the test's process saw during the whole
 * run stands for each of them. That excuses more than the probe of a single time would, so an
 * excused demonstration is played once more.
 *
 * @param targets in the order printed
 */
record DemoTimes(List<Target> targets) {

  private static final String HEADING = "Measured";

  /** What is measured, then the value, its unit and the target; see {@code Figure.lines}. */
  private static final Pattern LINE =
      Pattern.compile(
          "  (?<what>.*\\S) +(?<measured>[-+0-9.e]+|Infinity|NaN) (?<unit>\\S*) *"
              + "  target ≤ (?<most>[-+0-9.e]+)(?: (?!MISSED)\\S+)?(?<missed> +MISSED)?");

  /** A figure without a target; the words of a folded name are one blank apart. */
  private static final Pattern STATED = Pattern.compile("  .*\\S {2,}[-+0-9.e]+(?: \\S+)?");

  private static final Map<String, Double> SECONDS =
      Map.of("s", 1.0, "ms", 1e-3, "µs", 1e-6, "ns", 1e-9);

  /** For a time that never came. */
  private static final Duration ENDLESS = Duration.ofDays(1);

  DemoTimes {
    targets = List.copyOf(targets);
  }

  /**
   * A figure with a target.
   *
   * @param what what was measured
   * @param measured the value as printed
   * @param most the target as printed
   * @param unit of both; empty for a plain number
   * @param isMissed whether the demonstration says so
   */
  record Target(String what, double measured, double most, String unit, boolean isMissed) {

    /**
     * The missed time beside what the whole run was like.
     *
     * @throws AssertionError if this is no time: then it must be true on every computer
     */
    private Timing in(Timing run) {
      Duration took = duration(measured);
      Duration least = bound().plusNanos(1); // rounding may have printed the target itself
      return run.ofPart(took.compareTo(least) < 0 ? least : took);
    }

    private Duration bound() {
      return duration(most);
    }

    private Duration duration(double value) {
      @Nullable Double seconds = SECONDS.get(unit);
      if (seconds == null) {
        throw new AssertionError(this + " is no time, so nothing excuses that it is missed");
      }
      double nanos = value * seconds * 1e9;
      return Double.isNaN(nanos) || nanos > ENDLESS.toNanos()
          ? ENDLESS
          : Duration.ofNanos(Math.round(nanos));
    }

    @Override
    public String toString() {
      return String.format(Locale.ROOT, "%s: %s %s, target ≤ %s", what, measured, unit, most);
    }
  }

  /** The lines between the heading and the next empty line. */
  static List<String> lines(String out) {
    return out.lines()
        .dropWhile(line -> !line.equals(HEADING))
        .skip(1)
        .takeWhile(line -> !line.isEmpty())
        .toList();
  }

  /**
   * Reads what a demonstration printed.
   *
   * @throws AssertionError if a line that names a target cannot be read
   */
  static DemoTimes of(String out) {
    List<Target> targets = new ArrayList<>();
    StringBuilder name = new StringBuilder(); // of a figure whose name is folded
    for (String line : lines(out)) {
      Matcher found = LINE.matcher(line);
      if (found.matches()) {
        targets.add(
            new Target(
                name + found.group("what"),
                Double.parseDouble(found.group("measured")),
                Double.parseDouble(found.group("most")),
                found.group("unit"),
                found.group("missed") != null));
        name.setLength(0);
      } else if (line.contains("wanted") || line.contains("MISSED")) {
        throw new AssertionError("this is no figure with a target: \"" + line + "\"");
      } else if (STATED.matcher(line).matches()) {
        name.setLength(0);
      } else {
        name.append(line.strip()).append(' ');
      }
    }
    return new DemoTimes(targets);
  }

  /** Those that the demonstration says are missed. */
  List<Target> missed() {
    return targets.stream().filter(Target::isMissed).toList();
  }

  /**
   * Why each missed time is excused, in a sentence; empty where nothing is missed, or where nothing
   * excuses one of them. {@code ./dfra test} lists the sentences that tell of a stall.
   *
   * @param run the whole run of the demonstration
   */
  List<String> excuses(Timing run) {
    List<String> excuses = new ArrayList<>();
    for (Target each : missed()) {
      BoundResult outcome = each.in(run).compareWith(each.bound());
      if (outcome == BoundResult.MISSED) {
        return List.of();
      }
      excuses.add(
          String.format(
              Locale.ROOT,
              "%s: %s; the computer stalled for %.3f s of %.0f s, with %.1f runnable threads per"
                  + " processor%s",
              outcome == BoundResult.MISSED_DURING_A_STALL
                  ? "MISSED DURING A STALL"
                  : "missed during an overload",
              each,
              run.stalled().toNanos() / 1e9,
              run.took().toNanos() / 1e9,
              run.load(),
              run.steal()));
    }
    return excuses;
  }

  /**
   * Returns if no time is missed, or if {@link Timing#requireWithin} lets each missed one pass.
   *
   * @param run the whole run of the demonstration
   * @throws AssertionError if a time is missed and nothing explains that
   */
  void require(Timing run) {
    missed().forEach(each -> each.in(run).requireWithin(each.what(), each.bound()));
  }
}
