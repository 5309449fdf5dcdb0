package org.dfra.cli.module;

import java.io.IOException;
import java.rmi.activation.ActivationException;
import java.util.List;
import org.dfra.cli.team.PhoenixOptions;
import org.dfra.core.config.NearestName;
import org.dfra.core.host.CommandName;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.bootstrap.PhoenixInventory;
import org.dfra.river.bootstrap.PhoenixInventory.ServiceGroup;
import org.dfra.river.bootstrap.PhoenixProcess;

/** Finds the service group of a module on this host. */
final class ServiceGroupFinder {

  private ServiceGroupFinder() {}

  /**
   * The group that the module runs in.
   *
   * @param module {@code robot/module}
   * @throws CommandFailure if this host has no such module
   */
  static ServiceGroup of(PhoenixProcess phoenix, String module)
      throws IOException, ActivationException {
    List<ServiceGroup> groups = PhoenixInventory.groups(phoenix, PhoenixOptions.TIMEOUT);
    return groups.stream()
        .filter(group -> paths(group).contains(module))
        .findFirst()
        .orElseThrow(
            () ->
                new CommandFailure(
                    ExitCode.NOT_FOUND,
                    "this host has no module "
                        + module
                        + hint(
                            module,
                            groups.stream().flatMap(each -> paths(each).stream()).toList())));
  }

  /** The robot must be named: these commands may end processes. */
  private static String hint(String module, List<String> paths) {
    return paths.stream()
        .filter(path -> path.endsWith("/" + module))
        .findFirst()
        .map(path -> "; did you mean \"" + path + "\"?")
        .orElseGet(
            () ->
                NearestName.hint(
                    module, paths, "; " + CommandName.current() + " status shows what it has"));
  }

  private static List<String> paths(ServiceGroup group) {
    return group.modules().stream().map(name -> group.robot() + "/" + name).toList();
  }
}
