package org.dfra.app.module;

import java.util.Map;
import java.util.concurrent.Callable;
import org.dfra.app.team.Administration;
import org.dfra.app.team.ModuleArgument;
import org.dfra.app.team.TeamDirectory;
import org.dfra.app.terminal.ExitCode;
import org.dfra.directory.ModuleListing;
import org.dfra.module.Module;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra module stop}. */
@Command(
    name = "stop",
    description = "Ends a module in an orderly way, until it is called again.",
    footer = {
      "",
      "Its device is closed and it leaves the registrars. Whoever has its proxy starts",
      "it with the next call; so does ./dfra module start on its host."
    })
final class ModuleStopCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private ModuleArgument module;

  @Override
  public Integer call() throws Exception {
    try (TeamDirectory team = module.open()) {
      ModuleListing<Module> listing = module.find(team);
      Administration.of(listing).deactivate();
      module
          .answer()
          .sentence(
              Map.of("module", listing.path(), "stopped", true),
              listing.path() + " is stopped; a call of its proxy or module start starts it.");
      return ExitCode.SUCCESS;
    }
  }
}
