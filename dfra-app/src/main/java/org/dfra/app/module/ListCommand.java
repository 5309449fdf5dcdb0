package org.dfra.app.module;

import java.util.Comparator;
import java.util.List;
import java.util.concurrent.Callable;
import org.dfra.app.team.Team;
import org.dfra.app.team.TeamOptions;
import org.dfra.app.terminal.ExitCode;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.Module;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code ./dfra module list}. */
@Command(name = "list", description = "Lists the modules of the team.")
final class ListCommand implements Callable<Integer> {

  @Option(names = "--robot", paramLabel = "ROBOT", description = "Only those of this robot.")
  private @Nullable String robot;

  @Option(
      names = "--kind",
      paramLabel = "KIND",
      description = "Only those of this kind, e.g. GPSSensor.")
  private @Nullable String kind;

  @Mixin
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private TeamOptions options;

  @Override
  public Integer call() throws Exception {
    try (Team team = options.open()) {
      ModuleQuery<Module> any = ModuleQuery.of(Module.class);
      List<ModuleView> modules =
          team.surveyed().find(robot == null ? any : any.robot(robot)).stream()
              .filter(each -> kind == null || Kinds.isOf(each.module(), kind))
              .map(ModuleView::of)
              .sorted(Comparator.comparing(ModuleView::path).thenComparing(ModuleView::host))
              .toList();
      ModuleTable.show(options.answer(), modules, nothing());
      team.remarkNamesakes();
      return ExitCode.WELL;
    }
  }

  private String nothing() {
    return "No module"
        + (robot == null ? "" : " of robot " + robot)
        + (kind == null ? "" : " of kind " + kind)
        + " is registered.";
  }
}
