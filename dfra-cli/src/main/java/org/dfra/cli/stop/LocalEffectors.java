package org.dfra.cli.stop;

import java.io.IOException;
import java.rmi.activation.ActivationException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotDescription.GroupDescription;
import org.dfra.core.host.CommandName;
import org.dfra.flow.effector.Effector;
import org.dfra.river.bootstrap.PhoenixInventory.RegisteredService;
import org.dfra.river.server.effector.EffectorServer;

/**
 * The effectors of this host's robots, which phoenix reaches without any lookup service. Phoenix
 * knows the registered services, including those of names that no XML has any more; the XML of the
 * robots that were brought up names further effectors.
 */
final class LocalEffectors {

  /** Queries phoenix for its registered services. */
  interface RegisteredServices {
    List<RegisteredService> services() throws IOException, ActivationException;
  }

  /**
   * One effector.
   *
   * @param robot name of its robot
   * @param name its name on its robot
   * @param access to its server
   */
  record LocalEffector(String robot, String name, EffectorAccess access) {

    /** {@code robot/name}. */
    String path() {
      return robot + "/" + name;
    }
  }

  /** Access to an effector. */
  interface EffectorAccess {
    /**
     * Its server, which is activated if it does not run.
     *
     * @throws IOException if phoenix does not answer
     * @throws ActivationException if it is not registered, or cannot be started
     */
    Effector<?> reach() throws IOException, ActivationException;
  }

  private final RegisteredServices phoenix;
  private final List<RobotDescription> known;
  private final Predicate<String> wanted;

  /**
   * @param known the robots that were brought up on this host, as far as their XML is known
   * @param wanted the selected robots, by name
   */
  LocalEffectors(
      RegisteredServices phoenix, List<RobotDescription> known, Predicate<String> wanted) {
    this.phoenix = phoenix;
    this.known = List.copyOf(known);
    this.wanted = wanted;
  }

  /**
   * All effectors: those registered with phoenix, and those that only the XML names, which cannot
   * be reached and report the reason. Omits modules whose classes are missing here: they must be
   * looked up.
   *
   * @throws IOException if phoenix does not answer and no XML names an effector
   * @throws ActivationException likewise
   */
  List<LocalEffector> all() throws IOException, ActivationException {
    List<LocalEffector> all = new ArrayList<>();
    try {
      for (RegisteredService each : services()) {
        if (wanted.test(each.robot()) && isEffector(each.serverClass())) {
          String name = each.name() == null ? "(in group " + each.group() + ")" : each.name();
          all.add(
              new LocalEffector(each.robot(), name, () -> (Effector<?>) each.id().activate(false)));
        }
      }
    } catch (IOException | ActivationException e) {
      named(
          all, "no lookup service has it, and phoenix of this host cannot be asked: " + reason(e));
      if (all.isEmpty()) {
        throw e;
      }
      return all;
    }
    named(
        all,
        "phoenix of this host does not have it registered, so it was not reached if it runs;"
            + " "
            + CommandName.current()
            + " up with the robot's XML puts that right");
    return all;
  }

  /** Queried once more if phoenix does not answer: on a loaded computer it may be late. */
  private List<RegisteredService> services() throws IOException, ActivationException {
    try {
      return phoenix.services();
    } catch (IOException | ActivationException e) {
      return phoenix.services();
    }
  }

  /** Without the cause that a remote exception appends. */
  private static String reason(Exception failure) {
    return String.valueOf(failure.getMessage()).replaceFirst("(?s);? nested exception is:.*", "");
  }

  private void named(List<LocalEffector> all, String whyNot) {
    Set<String> found = new HashSet<>();
    all.forEach(each -> found.add(each.path()));
    for (RobotDescription robot : known) {
      for (GroupDescription group : robot.groups()) {
        for (ModuleDescription module : group.modules()) {
          if (wanted.test(robot.name())
              && isEffector(module.serverClass())
              && !found.contains(module.path())) {
            all.add(
                new LocalEffector(
                    robot.name(),
                    module.name(),
                    () -> {
                      throw new ActivationException(whyNot);
                    }));
          }
        }
      }
    }
  }

  private static boolean isEffector(String serverClass) {
    try {
      Class<?> server = Class.forName(serverClass, false, LocalEffectors.class.getClassLoader());
      return EffectorServer.class.isAssignableFrom(server);
    } catch (ClassNotFoundException | LinkageError e) {
      return false;
    }
  }
}
