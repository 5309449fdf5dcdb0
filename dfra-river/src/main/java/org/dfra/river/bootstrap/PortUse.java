package org.dfra.river.bootstrap;

import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.RegistrarDescription;
import org.dfra.core.host.CommandName;
import org.dfra.river.loading.RobotCodebase;
import org.dfra.river.phoenix.PhoenixAdmin;

/**
 * The TCP ports of the other robots of a phoenix, so that a message about a conflict names the
 * robot.
 */
final class PortUse {

  /**
   * One port.
   *
   * @param robot name of the robot that has it
   * @param purpose its purpose, such as {@code registrar}
   */
  record UsedPort(String host, int port, String robot, String purpose) {

    /** {@code port 4160 is used by robot atrv2's registrar}. */
    String describe() {
      return "port " + port + " is used by robot " + robot + "'s " + purpose;
    }
  }

  private final List<UsedPort> uses;

  PortUse(List<UsedPort> uses) {
    this.uses = List.copyOf(uses);
  }

  /** The ports of every robot but one. */
  static PortUse ofOthers(PhoenixAdmin admin, String robot, RetryDeadline patience)
      throws IOException, ActivationException {
    return patience.call(
        () -> {
          List<UsedPort> uses = new ArrayList<>();
          @SuppressWarnings("unchecked") // as phoenix declares it
          Map<ActivationGroupID, ActivationGroupDesc> groups = admin.getActivationGroups();
          for (Map.Entry<ActivationGroupID, ActivationGroupDesc> each : groups.entrySet()) {
            String name = RegisteredGroup.fullName(each.getValue());
            int dot = name.indexOf('.');
            if (dot > 0 && !name.substring(0, dot).equals(robot)) {
              @SuppressWarnings("unchecked") // as phoenix declares it
              Map<ActivationID, ActivationDesc> objects =
                  admin.getActivatableObjects(each.getKey());
              for (ActivationDesc object : objects.values()) {
                add(uses, name.substring(0, dot), object, each.getValue());
              }
            }
          }
          return new PortUse(uses);
        });
  }

  private static void add(
      List<UsedPort> uses, String robot, ActivationDesc object, ActivationGroupDesc group)
      throws ActivationException {
    if (object.getClassName().equals(BootstrapLoader.REGGIE)
        && RegisteredGroup.data(object) instanceof String[] arguments) {
      String host = RegistrarArguments.host(List.of(arguments)).orElse("");
      uses.add(new UsedPort(host, RegistrarArguments.port(List.of(arguments)), robot, "registrar"));
      RobotCodebase.servedPort(List.of(group.getCommandEnvironment().getCommandOptions()))
          .ifPresent(port -> uses.add(new UsedPort(host, port, robot, "class server")));
    }
  }

  /** The robot that uses a port; empty if no other robot uses it, or if it is 0. */
  Optional<UsedPort> of(String host, int port) {
    return uses.stream()
        .filter(each -> port != 0 && each.port() == port && isSame(each.host(), host))
        .findFirst();
  }

  private static boolean isSame(String one, String other) {
    try {
      return one.equals(other) || InetAddress.getByName(one).equals(InetAddress.getByName(other));
    } catch (UnknownHostException e) {
      return false;
    }
  }

  /**
   * Refuses a registrar at a port that another robot has.
   *
   * @throws ConfigurationException naming that robot
   */
  void requireFree(String robot, String host, RegistrarDescription registrar) {
    of(host, registrar.port())
        .ifPresent(
            use -> {
              throw new ConfigurationException(
                  registrar.place()
                      + ": "
                      + robot
                      + "/registrar cannot start: "
                      + use.describe()
                      + "; give one of the two another port, or "
                      + CommandName.current()
                      + " down "
                      + use.robot());
            });
  }
}
