package org.dfra.app.benchmark;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.function.Supplier;
import org.dfra.app.measurement.RecordOption;
import org.dfra.app.terminal.ExitCode;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code ./dfra bench}: measures the quantities for which the requirements state a target. */
@Command(
    name = "bench",
    description = "Measures what the requirements put a figure on, on this machine.",
    footer = {
      "",
      "Benchmarks:",
      "  attack        a robot under attack by a stranger (twelve minutes; less by --seconds)",
      "  calls         a small remote call, and the check of its bytes (fifteen seconds)",
      "  distributed   lookup, queries, staleness, renewals, events (four minutes)",
      "  events        of these, the latency of events alone",
      "  fuzzy         fuzzy inference with 135 rules (thirty seconds)",
      "  lockstep      how much faster than real time drivers are in lock-step (one minute)",
      "  mines         how often the mine detector is right, in many looks (one minute)",
      "  navigation    robots that search a field, over many seeds (an hour; fewer by --seeds)",
      "  parsers       the devices' parsers (fifteen seconds)",
      "  recruit       messages between agents, and how long letters and events take (three minutes)",
      "  world         simulated robots that scan, and pictures (half a minute)"
    })
public final class BenchCommand implements Callable<Integer> {

  private final Map<String, Supplier<Bench>> benches = new LinkedHashMap<>();

  /** Lists all benchmarks; runs none. */
  public BenchCommand() {
    benches.put("attack", () -> new AttackBench(seconds));
    benches.put("calls", CallBench::new);
    benches.put("distributed", DistributedBench::new);
    benches.put("events", EventBench::new);
    benches.put("fuzzy", FuzzyBench::new);
    benches.put("lockstep", LockStepBench::new);
    benches.put("mines", MinesBench::new);
    benches.put("navigation", () -> new NavigationBench(seeds, folder("navigation")));
    benches.put("parsers", ParserBench::new);
    benches.put("recruit", () -> new RecruitBench(folder("recruit")));
    benches.put("world", WorldBench::new);
  }

  @Parameters(paramLabel = "NAME", description = "Which one.")
  private String name = "";

  @Option(
      names = "--seeds",
      paramLabel = "N",
      description = "How many seeds the benchmark navigation runs (default ${DEFAULT-VALUE}).")
  private int seeds = 200;

  @Option(
      names = "--seconds",
      paramLabel = "S",
      description = "How long the benchmark attack repeats each attack (default ${DEFAULT-VALUE}).")
  private int seconds = 30;

  @Option(
      names = "--report",
      paramLabel = "DIR",
      description =
          "Where the benchmarks navigation and recruit put what they write (default"
              + " reports/NAME).")
  private @Nullable Path folder;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private RecordOption record;

  @Spec
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandSpec spec;

  private Path folder(String ofBench) {
    return folder == null ? Path.of("reports", ofBench) : folder;
  }

  @Override
  public Integer call() throws Exception {
    @Nullable Supplier<Bench> bench = benches.get(name);
    if (bench == null) {
      throw new ParameterException(
          spec.commandLine(),
          "there is no benchmark \"" + name + "\"; there is " + benches.keySet());
    }
    if (seconds < 1) {
      throw new ParameterException(
          spec.commandLine(), "--seconds " + seconds + " is below 1; give 1 or more");
    }
    Report report = new Report(spec.commandLine().getOut());
    bench.get().run(report);
    record.append(report.figures(), "bench", name);
    return report.figures().missed().isEmpty() ? ExitCode.SUCCESS : ExitCode.FAILED;
  }
}
