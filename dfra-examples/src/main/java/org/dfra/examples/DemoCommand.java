package org.dfra.examples;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import org.dfra.examples.devices.DevicesDemo;
import org.dfra.examples.foundation.FoundationDemo;
import org.dfra.examples.harness.CpuSpeed;
import org.dfra.examples.harness.DemoRunner.Demo;
import org.dfra.examples.persona.PersonaDemo;
import org.dfra.examples.raster.RasterDemo;
import org.dfra.examples.raster.RasterOptions;
import org.dfra.examples.recruit.RecruitDemo;
import org.dfra.examples.security.SecurityDemo;
import org.dfra.report.measurement.RecordOption;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.report.terminal.ExitCode;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code ./dfra demo}: runs a demonstration; by default the search with two robots. */
@Command(
    name = "demo",
    description = "Runs a demonstration on this machine.",
    footer = {
      "",
      "Exits with 1 if a step fails, or if a required condition is not met: for example, a",
      "module did not recover, or there was a collision. Durations depend on the computer:",
      "times are shown as met or missed, with this computer's current speed. With --strict",
      "it also exits with 1 if a time bound is missed.",
      "",
      "Demonstrations:",
      "  raster       two robots search a field lane by lane; writes a report",
      "  recruit      robots call for help and help each other; writes a report",
      "  devices      one robot in a simulated world with all its devices; writes a report",
      "  persona      two robots: modules found by what they can do, also after failures",
      "  security     two robots search: operators, an observer, a stranger, rogues, a policy",
      "  foundation   a GPS receiver found by what it can do, and restarted after kill -9"
    })
final class DemoCommand implements Callable<Integer> {

  /** By name; the first is the default. */
  private final Map<String, BiFunction<ProgressReporter, Path, Demo>> demos = new LinkedHashMap<>();

  /** Lists all demonstrations; runs none. */
  public DemoCommand() {
    demos.put("raster", (progress, folder) -> RasterDemo.of(progress, raster, folder));
    demos.put("recruit", (progress, folder) -> RecruitDemo.of(progress, raster.speed(), folder));
    demos.put("devices", DevicesDemo::new);
    demos.put("persona", (progress, report) -> new PersonaDemo(progress));
    demos.put("security", (progress, report) -> new SecurityDemo(progress));
    demos.put("foundation", (progress, report) -> new FoundationDemo(progress));
  }

  @Parameters(
      arity = "0..1",
      paramLabel = "NAME",
      description = "Demonstration to run (default raster).")
  private @Nullable String name;

  @Option(
      names = "--report",
      paramLabel = "DIR",
      description = "Folder of the report, if the demonstration writes one (default reports/NAME).")
  private @Nullable Path report;

  @Option(names = "--strict", description = "Also fail if a time bound is missed.")
  private boolean isStrict;

  @Mixin private final RasterOptions raster = new RasterOptions();

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private RecordOption record;

  @Spec
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandSpec spec;

  @Override
  public Integer call() throws Exception {
    PrintWriter out = spec.commandLine().getOut();
    String chosen = name == null ? demos.keySet().iterator().next() : name;
    BiFunction<ProgressReporter, Path, Demo> demo = demos.get(chosen);
    if (demo == null) {
      throw new ParameterException(
          spec.commandLine(),
          "there is no demonstration \""
              + chosen
              + "\"; there is "
              + String.join(", ", demos.keySet()));
    }
    refuseOptionsOfOthers(chosen);
    ProgressReporter progress = ProgressReporter.to(out);
    if (!demo.apply(progress, report == null ? Path.of("reports", chosen) : report).run()) {
      return ExitCode.FAILED;
    }
    record.append(progress.figures(), "demo", chosen);
    DemoVerdict verdict = new DemoVerdict(progress.figures(), isStrict);
    verdict.sentences(CpuSpeed::relativeToReference).forEach(progress::remark);
    return verdict.passed() ? ExitCode.SUCCESS : ExitCode.FAILED;
  }

  /** The raster options are valid with demonstration raster only. */
  private void refuseOptionsOfOthers(String chosen) {
    if (chosen.equals("raster")) {
      return;
    }
    Set<String> ofRaster =
        CommandSpec.forAnnotatedObject(new RasterOptions()).options().stream()
            .map(OptionSpec::longestName)
            .collect(Collectors.toSet());
    for (OptionSpec given : spec.commandLine().getParseResult().matchedOptions()) {
      boolean isUnderstood = chosen.equals("recruit") && given.longestName().equals("--speed");
      if (ofRaster.contains(given.longestName()) && !isUnderstood) {
        throw new ParameterException(
            spec.commandLine(),
            given.longestName()
                + " is an option of the demonstration raster; "
                + chosen
                + " does not have it");
      }
    }
  }
}
