package org.dfra.cli.persona;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import org.dfra.cli.module.ModuleKinds;
import org.dfra.cli.module.ModuleListPrinter;
import org.dfra.cli.module.ModuleView;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.cli.team.TeamOptions;
import org.dfra.core.query.QueryParser;
import org.dfra.core.query.QuerySyntaxException;
import org.dfra.core.query.QueryTypeNames;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.Module;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra persona find}. */
@Command(
    name = "find",
    description =
        "Finds modules by what they can do, the best first; exits with 3 if there is none.",
    footer = {
      "",
      "For example:",
      "  'GPSSensor'",
      "  'GPSSensor named gps_front on atrv1'",
      "  'LocationSensor with sensor.maxRate >= 1 and module.state = ready'",
      "  'GPSSensor with gps_receiver.fixModes contains \"3D\"'",
      "  'Sensor with sensor.power from 0 to 5 within 50 m of 27.98, -82.45'",
      "",
      "The language: docs/how-to/find-and-watch-modules.md"
    })
final class FindCommand implements Callable<Integer> {

  @Parameters(
      arity = "1..*",
      paramLabel = "QUERY",
      description = "A kind of module and conditions, in quotation marks.")
  private List<String> words = List.of();

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private TeamOptions options;

  @Override
  public Integer call() throws Exception {
    try (TeamDirectory team = options.open()) {
      ModuleDirectory directory = team.awaitDirectory();
      ModuleQuery<? extends Module> query = query(directory);
      List<ModuleView> found = directory.find(query).stream().map(ModuleView::of).toList();
      ModuleListPrinter.show(options.answer(), found, "There is no " + query + ".");
      return found.isEmpty() ? ExitCode.NOT_FOUND : ExitCode.SUCCESS;
    }
  }

  private ModuleQuery<? extends Module> query(ModuleDirectory directory) {
    Set<Class<?>> seen = new LinkedHashSet<>();
    for (ModuleListing<Module> each : directory.find(ModuleQuery.of(Module.class))) {
      seen.addAll(ModuleKinds.interfaces(each.module()));
      each.attributes().forEach(attributes -> seen.add(attributes.getClass()));
    }
    try {
      return new QueryParser(QueryTypeNames.standard().with(seen)).parse(String.join(" ", words));
    } catch (QuerySyntaxException e) {
      throw new CommandFailure(ExitCode.USAGE_ERROR, "in the query, " + e.getMessage(), e);
    }
  }
}
