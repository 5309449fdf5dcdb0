package org.dfra.cli.module;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.dfra.cli.team.ModuleArgument;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.module.Diagnosable;
import org.dfra.module.Diagnosis;
import org.dfra.report.terminal.ExitCode;
import org.dfra.report.terminal.Table;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra module diagnose}. */
@Command(
    name = "diagnose",
    description = "Runs a module's hardware tests; exits with 1 if one fails.")
final class DiagnoseCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private ModuleArgument module;

  @Parameters(
      index = "1",
      arity = "0..1",
      paramLabel = "TEST",
      description = "Which one; without it, all.")
  private @Nullable String test;

  @Override
  public Integer call() throws Exception {
    try (TeamDirectory team = module.open()) {
      Diagnosable asked = Diagnosables.of(module.find(team));
      List<String> tests = asked.tests();
      List<Diagnosis> results = new ArrayList<>();
      for (String each : test == null ? tests : List.of(known(tests, test))) {
        results.add(asked.test(each));
      }
      Table table = new Table("TEST", "RESULT", "DURATION", "FINDING");
      results.forEach(
          each ->
              table.row(
                  each.name(),
                  each.passed() ? "passed" : "FAILED",
                  String.format(Locale.ROOT, "%.1f s", each.duration().toNanos() / 1e9),
                  each.finding()));
      module.answer().table(results, table, module.name() + " has no tests.");
      return results.stream().allMatch(Diagnosis::passed) ? ExitCode.SUCCESS : ExitCode.FAILED;
    }
  }

  private String known(List<String> tests, String wanted) {
    return Diagnosables.known(module.name(), "test", tests, wanted);
  }
}
