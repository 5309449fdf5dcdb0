package org.dfra.cli.module;

import java.util.Map;
import java.util.concurrent.Callable;
import org.dfra.cli.team.Administration;
import org.dfra.cli.team.ModuleArgument;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.core.host.CommandName;
import org.dfra.directory.ModuleListing;
import org.dfra.module.Module;
import org.dfra.module.Parameter;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.bootstrap.RobotBootstrap;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra module}: queries and changes of modules. */
@Command(
    name = "module",
    description = "Lists, queries and changes the team's modules.",
    synopsisSubcommandLabel = "COMMAND",
    commandListHeading = "%nCommands:%n",
    subcommands = {
      ModuleListCommand.class,
      InfoCommand.class,
      CallCommand.class,
      GetCommand.class,
      ModuleCommand.SetCommand.class,
      ModuleCommand.StartCommand.class,
      ModuleCommand.ModuleStopCommand.class,
      KillCommand.class,
      ModuleCommand.AddCommand.class,
      ModuleCommand.ReplaceCommand.class,
      ModuleCommand.RemoveCommand.class,
      DiagnoseCommand.class,
      RecoverCommand.class
    })
public final class ModuleCommand {

  /** {@code ./dfra module set}. */
  @Command(name = "set", description = "Sets a module's parameter, until the module is restarted.")
  static final class SetCommand implements Callable<Integer> {

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
        String name = GetCommand.find(target.parameters(), parameter, listing.path()).name();
        target.setParameter(name, value);
        Parameter now = GetCommand.find(target.parameters(), name, listing.path());
        module.answer().sentence(now, listing.path() + ": " + name + " is " + now.value() + ".");
        return ExitCode.SUCCESS;
      }
    }
  }

  /** {@code ./dfra module start}. */
  @Command(
      name = "start",
      description = "Starts a module of this host that was stopped or has crashed.",
      footer = {"", "If the module already runs, nothing happens."})
  static final class StartCommand implements Callable<Integer> {

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before the call
    private LocalModule local;

    @Override
    public Integer call() throws Exception {
      local.change(RobotBootstrap::start, "started");
      return ExitCode.SUCCESS;
    }
  }

  /** {@code ./dfra module stop}. */
  @Command(
      name = "stop",
      description = "Ends a module in an orderly way, until it is called again.",
      footer = {
        "",
        "It closes its device and deregisters. The next call through its proxy starts it again;",
        "so does " + CommandName.IN_HELP + " module start on its host."
      })
  static final class ModuleStopCommand implements Callable<Integer> {

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

  /** {@code ./dfra module add}. */
  @Command(
      name = "add",
      description = "Adds a module to a running robot of this host, while its other modules run.",
      footer = {"", "Add the module to the robot's XML first; then name the XML and the module."})
  static final class AddCommand implements Callable<Integer> {

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before the call
    private ConfiguredModuleArgument described;

    @Override
    public Integer call() throws Exception {
      RobotBootstrap.ServiceReference service = described.change(RobotBootstrap::add);
      described
          .answer()
          .sentence(
              Map.of("module", service.name(), "group", service.group(), "added", true),
              "Added " + service.name() + " to group " + service.group() + ".");
      return ExitCode.SUCCESS;
    }
  }

  /** {@code ./dfra module replace}. */
  @Command(
      name = "replace",
      description =
          "Replaces a module of a running robot of this host according to its current XML.",
      footer = {
        "",
        "The module keeps its identity: clients that have its proxy continue with the new one.",
        "The other modules continue to run."
      })
  static final class ReplaceCommand implements Callable<Integer> {

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before the call
    private ConfiguredModuleArgument described;

    @Override
    public Integer call() throws Exception {
      RobotBootstrap.ServiceReference service =
          described.change((robot, module, group) -> robot.replace(module));
      described
          .answer()
          .sentence(
              Map.of("module", service.name(), "group", service.group(), "replaced", true),
              "Replaced " + service.name() + " in group " + service.group() + ".");
      return ExitCode.SUCCESS;
    }
  }

  /** {@code ./dfra module remove}. */
  @Command(
      name = "remove",
      description =
          "Removes a module from a running robot of this host, while its other modules run.",
      footer = {
        "",
        "If the robot's XML still contains the module, the next "
            + CommandName.IN_HELP
            + " up starts it again."
      })
  static final class RemoveCommand implements Callable<Integer> {

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before the call
    private LocalModule local;

    @Override
    public Integer call() throws Exception {
      local.change(RobotBootstrap::remove, "removed");
      return ExitCode.SUCCESS;
    }
  }
}
