package org.dfra.cli.module;

import java.util.List;
import java.util.concurrent.Callable;
import org.dfra.cli.team.ModuleArgument;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.core.config.NearestName;
import org.dfra.core.config.RenamedNames;
import org.dfra.module.Parameter;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.dfra.report.terminal.Table;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra module get}. */
@Command(name = "get", description = "Reads a module's parameters, or one of them.")
final class GetCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private ModuleArgument module;

  @Parameters(
      index = "1",
      arity = "0..1",
      paramLabel = "PARAMETER",
      description = "Which one; without it, all.")
  private @Nullable String parameter;

  @Override
  public Integer call() throws Exception {
    try (TeamDirectory team = module.open()) {
      List<Parameter> all = module.find(team).module().parameters();
      String wanted = parameter;
      if (wanted == null) {
        Table table = new Table("PARAMETER", "VALUE", "SETTABLE", "DESCRIPTION");
        all.forEach(
            each ->
                table.row(
                    each.name(), each.value(), each.settable() ? "yes" : "no", each.description()));
        module.answer().table(all, table, module.name() + " has no parameters.");
      } else {
        Parameter found = find(all, wanted, module.name());
        module.answer().sentence(found, found.value());
      }
      return ExitCode.SUCCESS;
    }
  }

  /**
   * The parameter with that name.
   *
   * @param module the module's name
   * @throws CommandFailure if there is none
   */
  static Parameter find(List<Parameter> all, String wanted, String module) {
    List<String> names = all.stream().map(Parameter::name).toList();
    String name = RenamedNames.resolve(module, "the parameter", wanted, names);
    return all.stream()
        .filter(each -> each.name().equals(name))
        .findFirst()
        .orElseThrow(() -> new CommandFailure(ExitCode.NOT_FOUND, unknown(names, wanted, module)));
  }

  private static String unknown(List<String> names, String wanted, String module) {
    return module
        + " has no parameter "
        + wanted
        + NearestName.hint(wanted, names, "; it has " + String.join(", ", names));
  }
}
