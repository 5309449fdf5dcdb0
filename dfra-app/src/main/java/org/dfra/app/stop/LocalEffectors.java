package org.dfra.app.stop;

import java.io.IOException;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.util.ArrayList;
import java.util.List;
import org.dfra.core.config.GroupDescription;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.RobotDescription;
import org.dfra.flow.effector.Effector;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.server.effector.EffectorServer;

/** The effectors of this host's robots, which phoenix reaches without any lookup service. */
final class LocalEffectors {

  private final PhoenixProcess phoenix;
  private final List<RobotDescription> robots;

  /**
   * @param robots what was brought up on this host
   */
  LocalEffectors(PhoenixProcess phoenix, List<RobotDescription> robots) {
    this.phoenix = phoenix;
    this.robots = List.copyOf(robots);
  }

  /**
   * Their descriptions. A module whose classes are not here is left out: it has to be looked up.
   */
  List<ModuleDescription> all() {
    List<ModuleDescription> all = new ArrayList<>();
    for (RobotDescription robot : robots) {
      for (GroupDescription group : robot.groups()) {
        group.modules().stream().filter(LocalEffectors::isEffector).forEach(all::add);
      }
    }
    return all;
  }

  private static boolean isEffector(ModuleDescription module) {
    try {
      Class<?> server =
          Class.forName(module.serverClass(), false, LocalEffectors.class.getClassLoader());
      return EffectorServer.class.isAssignableFrom(server);
    } catch (ClassNotFoundException | LinkageError e) {
      return false;
    }
  }

  /**
   * The server of one of them. It is started where it does not run.
   *
   * @throws IOException if phoenix does not answer
   * @throws ActivationException if it cannot be started
   */
  Effector<?> reach(ModuleDescription module) throws IOException, ActivationException {
    RobotDescription robot =
        robots.stream()
            .filter(each -> each.name().equals(module.robot()))
            .findFirst()
            .orElseThrow(
                () -> new IllegalArgumentException(module.path() + " is not of this host"));
    if (!phoenix.answers()) {
      throw new RemoteException(
          "no lookup service has it, and phoenix of this host does not answer on port "
              + phoenix.port());
    }
    return (Effector<?>) new RobotBootstrap(phoenix, robot).reach(module.name());
  }
}
