package org.dfra.app.bench;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.function.Supplier;
import org.dfra.app.figure.RecordOption;
import org.dfra.app.terminal.ExitCode;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code ./dfra bench}: measures what the requirements put a figure on. */
@Command(
    name = "bench",
    description = "Measures what the requirements put a figure on, on this machine.",
    footer = {
      "",
      "Benchmarks:",
      "  distributed   lookup, queries, staleness, renewals, events (four minutes)",
      "  events        of these, the latency of events alone",
      "  parsers       the receivers' parsers (ten seconds)"
    })
public final class BenchCommand implements Callable<Integer> {

  private static final Map<String, Supplier<Bench>> BENCHES = new LinkedHashMap<>();

  static {
    BENCHES.put("distributed", DistributedBench::new);
    BENCHES.put("events", EventBench::new);
    BENCHES.put("parsers", ParserBench::new);
  }

  @Parameters(paramLabel = "NAME", description = "Which one.")
  private String name = "";

  @Mixin
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private RecordOption record;

  @Spec
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private CommandSpec spec;

  @Override
  public Integer call() throws Exception {
    @Nullable Supplier<Bench> bench = BENCHES.get(name);
    if (bench == null) {
      throw new ParameterException(
          spec.commandLine(),
          "there is no benchmark \"" + name + "\"; there is " + BENCHES.keySet());
    }
    Report report = new Report(spec.commandLine().getOut());
    bench.get().run(report);
    record.keep(report.figures(), "bench", name);
    return report.figures().missed().isEmpty() ? ExitCode.WELL : ExitCode.FAILED;
  }
}
