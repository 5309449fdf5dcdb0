package org.dfra.cli.module;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.dfra.cli.team.PhoenixOptions;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.NearestName;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotDescription.GroupDescription;
import org.dfra.core.config.RobotXml;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.bootstrap.RobotDescriptionStore;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** A module of a robot on this host, by the robot's XML. A picocli mix-in. */
final class ConfiguredModuleArgument {

  @Parameters(
      index = "0",
      paramLabel = "ROBOT.XML",
      description = "The robot's description, with the module in it.")
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private Path xml;

  @Parameters(index = "1", paramLabel = "MODULE", description = "Name of the module.")
  private String name = "";

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private PhoenixOptions phoenix;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  CommandOutput answer() {
    return answer;
  }

  /** A change of the module, given its group's description. */
  interface Change {
    RobotBootstrap.ServiceReference apply(
        RobotBootstrap robot, ModuleDescription module, String group) throws Exception;
  }

  /** Executes the change, and stores the robot's new description. */
  RobotBootstrap.ServiceReference change(Change change) throws Exception {
    RobotDescription robot = RobotXml.read(xml);
    for (GroupDescription group : robot.groups()) {
      for (ModuleDescription module : group.modules()) {
        if (module.name().equals(name)) {
          RobotBootstrap bootstrap = new RobotBootstrap(phoenix.requireRunning(), robot);
          RobotBootstrap.ServiceReference service = change.apply(bootstrap, module, group.name());
          remember(robot);
          return service;
        }
      }
    }
    List<String> names = robot.modules().stream().map(ModuleDescription::name).toList();
    throw new ConfigurationException(
        xml
            + ": robot "
            + robot.name()
            + " has no module "
            + name
            + NearestName.hint(
                name, names, "; write it into one of the robot's groups and try again"));
  }

  private void remember(RobotDescription robot) throws IOException {
    new RobotDescriptionStore(phoenix.state()).save(robot);
  }
}
