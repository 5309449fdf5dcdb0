package org.dfra.benchmarks;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import java.util.regex.PatternSyntaxException;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dfra.benchmarks.MicroTask.MicroSettings;
import org.dfra.benchmarks.call.CallComparison;
import org.dfra.benchmarks.call.CallSettings;
import org.dfra.benchmarks.event.EventSettings;
import org.dfra.benchmarks.micro.MicroBenchmark;
import org.dfra.report.measurement.RecordOption;
import org.dfra.report.terminal.ExitCode;
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
    description = "Runs the benchmarks of the requirements on this machine.",
    footer = {
      "",
      "Benchmarks:",
      "  attack        a robot that other programs attack (twelve minutes; less with --seconds)",
      "  call          a call between processes; also RMI, JERI, JeroMQ (40 minutes; less with --only)",
      "  calls         a small remote call, and the check of its bytes (fifteen seconds)",
      "  distributed   lookup, queries, staleness, renewals, events (four minutes)",
      "  events        events to 20 processes; also a bare TCP program (nine minutes; --quick)",
      "  fuzzy         fuzzy inference with 135 rules (thirty seconds)",
      "  lockstep      how much faster than real time drivers run in lock-step (one minute)",
      "  micro         single operations: a call, marshalling, a parser (seven minutes; less with --only)",
      "  mines         how often the mine detector is right, over many images (one minute)",
      "  navigation    robots that search a field, over many seeds (an hour; less with --seeds)",
      "  parsers       the devices' parsers (fifteen seconds)",
      "  recruit       messages between agents, latency of messages and events (three minutes)",
      "  scale         teams of 2, 10, 30 and 100 robots (twenty minutes; less with --robots)",
      "  secure        revocation, and recovery of secure robots beside open ones (ten minutes; --quick)",
      "  start         robots' start, recovery and memory, with and without archive (five minutes)",
      "  world         simulated robots with laser scans and images (half a minute)"
    })
final class BenchCommand implements Callable<Integer> {

  private final Map<String, Supplier<Bench>> benches = new LinkedHashMap<>();

  /** Lists all benchmarks; runs none. */
  public BenchCommand() {
    benches.put("attack", () -> new AttackBench(seconds));
    benches.put("call", this::callComparison);
    benches.put("calls", CallBench::new);
    benches.put("distributed", DistributedBench::new);
    benches.put("events", this::events);
    benches.put("fuzzy", FuzzyBench::new);
    benches.put("lockstep", LockStepBench::new);
    benches.put("micro", this::micro);
    benches.put("mines", MinesBench::new);
    benches.put("navigation", () -> new NavigationBench(seeds, folder("navigation")));
    benches.put("parsers", ParserBench::new);
    benches.put("recruit", () -> new RecruitBench(folder("recruit")));
    benches.put("scale", () -> new ScaleBench(sizes, folder("scale")));
    benches.put("secure", () -> new SecureBench(quick));
    benches.put("start", StartBench::new);
    benches.put("world", WorldBench::new);
  }

  @Parameters(paramLabel = "NAME", description = "Name of the benchmark.")
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
      names = "--robots",
      paramLabel = "N",
      split = ",",
      description =
          "Numbers of robots of the benchmark scale, ascending, separated by commas (default"
              + " 2,10,30,100).")
  private List<Integer> sizes = ScaleBench.SIZES;

  @Option(
      names = "--report",
      paramLabel = "DIR",
      description =
          "Folder for the output of the benchmarks navigation, recruit and scale (default"
              + " reports/NAME).")
  private @Nullable Path folder;

  @Option(
      names = "--only",
      paramLabel = "REGEX",
      description =
          "Which operations the benchmark micro runs, or which conditions the benchmark call"
              + " (default: all).")
  private @Nullable String only;

  @Option(
      names = "--quick",
      description =
          "The benchmarks call, events, micro and secure run for a minute or less; their figures are"
              + " inaccurate.")
  private boolean quick;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private RecordOption record;

  @Spec
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandSpec spec;

  private Path folder(String ofBench) {
    return folder == null ? Path.of("reports", ofBench) : folder;
  }

  /** The operations or conditions that the user chooses; null for all. */
  private @Nullable Pattern chosen() {
    try {
      return only == null ? null : Pattern.compile(only);
    } catch (PatternSyntaxException e) {
      throw new ParameterException(
          spec.commandLine(),
          "--only \"" + only + "\" is no regular expression: " + e.getDescription(),
          e);
    }
  }

  private ParameterException noneOf(Stream<String> names) {
    return new ParameterException(
        spec.commandLine(),
        "--only \""
            + only
            + "\" matches none of: "
            + names.distinct().collect(Collectors.joining("; ")));
  }

  private Bench micro() {
    List<MicroBenchmark> matching = MicroBenchmark.matching(chosen());
    if (matching.isEmpty()) {
      throw noneOf(MicroBenchmark.ALL.stream().map(MicroBenchmark::operation));
    }
    return new MicroBench(matching, quick ? MicroSettings.QUICK : MicroSettings.FULL);
  }

  private Bench events() {
    return new EventComparisonBench(quick ? EventSettings.QUICK : EventSettings.FULL);
  }

  private Bench callComparison() {
    CallSettings settings = quick ? CallSettings.QUICK : CallSettings.FULL;
    List<CallComparison> matching = CallComparisonBench.matching(chosen(), settings);
    if (matching.isEmpty()) {
      throw noneOf(
          CallComparisonBench.matching(null, settings).stream().map(CallComparison::title));
    }
    return new CallComparisonBench(matching, settings);
  }

  /** The name in records, where a short run is not to be taken for a full one. */
  private String recordedName() {
    return quick && Set.of("micro", "call", "events", "secure").contains(name)
        ? name + " quick"
        : name;
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
    for (int i = 0; i < sizes.size(); i++) {
      if (sizes.get(i) <= (i == 0 ? 0 : sizes.get(i - 1))) {
        throw new ParameterException(
            spec.commandLine(),
            "--robots " + sizes + " are not ascending numbers above 0; give such numbers");
      }
    }
    Report report = new Report(spec.commandLine().getOut());
    bench.get().run(report);
    record.append(report.figures(), "bench", recordedName());
    return report.figures().missed().isEmpty() ? ExitCode.SUCCESS : ExitCode.FAILED;
  }
}
