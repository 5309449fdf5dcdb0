package org.dfra.cli.module;

import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.dfra.cli.team.ModuleArgument;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.module.Idempotent;
import org.dfra.report.terminal.ExitCode;
import org.dfra.report.terminal.Table;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra module call}. */
@Command(
    name = "call",
    description = "Calls a module's method, or lists its methods.",
    footer = {
      "",
      "An argument is written as text, a number, the name of a constant, an instant in ISO",
      "8601, a duration in seconds, or else in JSON."
    })
final class CallCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private ModuleArgument module;

  @Parameters(
      index = "1",
      arity = "0..1",
      paramLabel = "METHOD",
      description = "Which method; without it, all are listed.")
  private @Nullable String method;

  @Parameters(index = "2..*", paramLabel = "ARGUMENT", description = "The method's arguments.")
  private List<String> arguments = new ArrayList<>();

  @Override
  public Integer call() throws Exception {
    try (TeamDirectory team = module.open()) {
      ModuleMethods calls = new ModuleMethods(module.find(team).module());
      if (method == null) {
        list(calls);
        return ExitCode.SUCCESS;
      }
      Object answer = calls.invoke(method, arguments);
      if (answer != null) {
        module.answer().details(answer);
      }
      return ExitCode.SUCCESS;
    }
  }

  private void list(ModuleMethods calls) {
    Table table = new Table("METHOD", "RETURNS", "IDEMPOTENT");
    List<Map<String, Object>> values = new ArrayList<>();
    for (Method each : calls.methods()) {
      boolean isRepeated = each.isAnnotationPresent(Idempotent.class);
      String type = ModuleMethods.name(each.getGenericReturnType());
      table.row(
          ModuleMethods.signature(each), type.replace("void", "-"), isRepeated ? "yes" : "no");
      values.add(
          Map.of(
              "method", ModuleMethods.signature(each), "returns", type, "idempotent", isRepeated));
    }
    module.answer().table(values, table, "");
  }
}
