package org.dfra.app.module;

import java.util.concurrent.Callable;
import org.dfra.app.team.ModuleArgument;
import org.dfra.app.team.TeamDirectory;
import org.dfra.app.terminal.ExitCode;
import org.dfra.directory.ModuleListing;
import org.dfra.module.Module;
import org.dfra.module.Parameter;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra module set}. */
@Command(name = "set", description = "Sets a module's parameter, until the module is started anew.")
final class SetCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private ModuleArgument module;

  @Parameters(index = "1", paramLabel = "PARAMETER", description = "Which one.")
  private String parameter = "";

  @Parameters(index = "2", paramLabel = "VALUE", description = "Its new value.")
  private String value = "";

  @Override
  public Integer call() throws Exception {
    try (TeamDirectory team = module.open()) {
      ModuleListing<Module> listing = module.find(team);
      Module target = listing.module();
      GetCommand.find(target.parameters(), parameter, listing.path()); // for its exit code
      target.setParameter(parameter, value);
      Parameter now = GetCommand.find(target.parameters(), parameter, listing.path());
      module.answer().sentence(now, listing.path() + ": " + parameter + " is " + now.value() + ".");
      return ExitCode.SUCCESS;
    }
  }
}
