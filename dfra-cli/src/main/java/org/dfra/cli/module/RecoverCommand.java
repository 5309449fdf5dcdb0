package org.dfra.cli.module;

import java.util.List;
import java.util.Map;
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

/** {@code ./dfra module recover}. */
@Command(
    name = "recover",
    description = "Runs one of a module's recoveries, or lists them; exits with 1 if it fails.")
final class RecoverCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private ModuleArgument module;

  @Parameters(
      index = "1",
      arity = "0..1",
      paramLabel = "RECOVERY",
      description = "Which one; without it, all are listed.")
  private @Nullable String recovery;

  @Override
  public Integer call() throws Exception {
    try (TeamDirectory team = module.open()) {
      Diagnosable asked = Diagnosables.of(module.find(team));
      List<String> recoveries = asked.recoveries();
      if (recovery == null) {
        Table table = new Table("RECOVERY");
        recoveries.forEach(table::row);
        module.answer().table(recoveries, table, module.name() + " has no recoveries.");
        return ExitCode.SUCCESS;
      }
      Diagnosis result =
          asked.recover(Diagnosables.known(module.name(), "recovery", recoveries, recovery));
      module
          .answer()
          .sentence(
              result,
              Map.of(true, "Recovered: ", false, "Not recovered: ").get(result.passed())
                  + result.finding());
      return result.passed() ? ExitCode.SUCCESS : ExitCode.FAILED;
    }
  }
}
