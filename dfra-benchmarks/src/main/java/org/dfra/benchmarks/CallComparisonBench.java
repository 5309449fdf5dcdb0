package org.dfra.benchmarks;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.dfra.benchmarks.call.CallComparison;
import org.dfra.benchmarks.call.CallCondition;
import org.dfra.benchmarks.call.CallKind;
import org.dfra.benchmarks.call.CallPeer;
import org.dfra.benchmarks.call.CallResults;
import org.dfra.benchmarks.call.CallSettings;
import org.dfra.benchmarks.call.EchoService;
import org.dfra.benchmarks.call.JitSetting;
import org.jspecify.annotations.Nullable;

/**
 * Compares the latency of a remote call between two processes by DFRA with that by Java RMI, JERI
 * and JeroMQ, under several conditions.
 */
final class CallComparisonBench implements Bench {

  private static final int COLUMNS = 132;

  private final List<CallComparison> chosen;
  private final CallSettings settings;

  CallComparisonBench(List<CallComparison> chosen, CallSettings settings) {
    this.chosen = List.copyOf(chosen);
    this.settings = settings;
  }

  /**
   * Comparisons of all peers under each condition with each JIT setting, whether or not this
   * computer can have it.
   *
   * @param titles is found in the titles of those that are returned; null for all
   */
  static List<CallComparison> matching(@Nullable Pattern titles, CallSettings settings) {
    List<CallComparison> matching = new ArrayList<>();
    for (CallCondition condition : CallCondition.values()) {
      for (JitSetting jit : JitSetting.values()) {
        CallComparison each =
            new CallComparison(condition, jit, List.of(CallPeer.values()), settings);
        if (titles == null || titles.matcher(each.title()).find()) {
          matching.add(each);
        }
      }
    }
    return matching;
  }

  @Override
  public void run(Report report) throws Exception {
    describe(report);
    List<CallComparison> possible = possible(report);
    if (possible.isEmpty()) {
      throw new IOException(
          "this computer can have none of the conditions that were chosen; choose others, or"
              + " install what the lines above name");
    }
    for (CallComparison each : possible) {
      CallResults results = each.run(report::say);
      report.say("");
      report.say(each.title());
      results.table().lines(COLUMNS).forEach(report::say);
      report.say("");
      results.figures().forEach(report.figures()::add);
    }
  }

  private void describe(Report report) {
    report.say(
        "A call from one process to another on this computer. Each figure is the median of "
            + settings.repetitions()
            + (settings.repetitions() == 1 ? " repetition" : " repetitions")
            + ", each in two new JVMs; the lowest and the highest ratio are in parentheses.");
    report.say(
        "Columns: p50 and p99 of a small call, µs; p50 of a call that returns "
            + EchoService.VALUES
            + " doubles, µs; small calls per second by "
            + CallKind.CALLERS.threads()
            + " threads at once; voluntary context switches and CPU time, µs, for a small call, of"
            + " the client + of the server.");
    report.say(
        "The kernel forgets the switches of a thread that ends: only those parts of a measurement"
            + " count in which none ended. \"≥\": there was no such part.");
    if (settings.equals(CallSettings.QUICK)) {
      report.say("This is a short run: it shows that all peers answer, not how fast.");
    }
    for (CallPeer each : CallPeer.values()) {
      report.say("  " + each.label() + ": " + each.description() + ".");
    }
    for (CallCondition each : conditions()) {
      if (each != CallCondition.NOT_PINNED) {
        report.say("  " + each.label() + ": " + each.description() + ".");
      }
    }
    for (JitSetting each : JitSetting.values()) {
      report.say("  " + each.label() + ": " + each.description() + ".");
    }
  }

  private List<CallCondition> conditions() {
    return Arrays.stream(CallCondition.values())
        .filter(each -> chosen.stream().anyMatch(one -> one.condition() == each))
        .toList();
  }

  /** Those that this computer can have; reports why it cannot have the others. */
  private List<CallComparison> possible(Report report) throws IOException, InterruptedException {
    List<CallComparison> possible = new ArrayList<>(chosen);
    for (CallCondition each : conditions()) {
      Optional<String> missing = CallComparison.missing(each);
      if (missing.isPresent()) {
        possible.removeIf(one -> one.condition() == each);
        if (each != CallCondition.NOT_PINNED) { // its lack is none where all else is possible
          report.say("skipped: \"" + each.label() + "\" needs " + missing.get());
        }
      }
    }
    return possible;
  }
}
