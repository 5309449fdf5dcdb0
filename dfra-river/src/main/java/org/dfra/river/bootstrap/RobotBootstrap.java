package org.dfra.river.bootstrap;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.util.ArrayList;
import java.util.List;
import org.dfra.core.config.GroupDescription;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.RegistrarDescription;
import org.dfra.core.config.RobotDescription;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Brings a robot up under a phoenix that runs: its registrar first, then its modules.
 *
 * <p>Doing it twice does no harm: what is registered already keeps its identity and gets the new
 * description, which counts from its next activation on.
 */
public final class RobotBootstrap {

  private static final Logger LOG = LoggerFactory.getLogger(RobotBootstrap.class);

  private final PhoenixProcess phoenix;
  private final RobotDescription robot;
  private final String host;

  /**
   * @param phoenix the phoenix of this host
   * @param robot the robot's description
   */
  public RobotBootstrap(PhoenixProcess phoenix, RobotDescription robot) {
    this.phoenix = phoenix;
    this.robot = robot;
    this.host = HostAddress.resolve(robot.host());
  }

  /**
   * What was brought up.
   *
   * @param name what it is, {@code robot/module}, or {@code robot/registrar}
   * @param group name of its service group
   * @param id its activation ID
   */
  public record Service(String name, String group, ActivationID id) {}

  /**
   * Registers everything and activates it.
   *
   * @return what was brought up, the registrar first
   * @throws ActivationException if something cannot be registered or activated; what was brought up
   *     before stays up
   */
  public List<Service> up() throws ActivationException, IOException {
    List<Service> services = new ArrayList<>();
    BootstrapLoader loader = new BootstrapLoader(phoenix.admin(), phoenix.system(), robot.name());
    // Steps 2 and 3: the registrar, so that the modules find it when they start.
    for (GroupDescription group : robot.groups()) {
      if (group.registrar().isPresent()) {
        services.add(activate(registrar(loader, group, group.registrar().get())));
      }
    }
    // Steps 4 to 8: the modules. Their XML and properties were read with the robot's description.
    for (GroupDescription group : robot.groups()) {
      ActivationGroupID groupId = loader.group(group);
      for (ModuleDescription module : group.modules()) {
        services.add(
            activate(
                loader.module(
                    groupId, group, module, host, locators(), multicastGroups(), state(module))));
      }
    }
    return services;
  }

  private Path state(ModuleDescription module) {
    return phoenix
        .state()
        .toAbsolutePath()
        .resolve("modules")
        .resolve(robot.name())
        .resolve(module.name());
  }

  private Service activate(Service service) throws ActivationException, RemoteException {
    try {
      service.id().activate(false);
    } catch (ActivationException e) {
      // Without the cause: an activation exception's message repeats its cause's.
      throw new ActivationException(service.name() + " did not start: " + e.getMessage());
    }
    LOG.info("{} is up in group {}.", service.name(), service.group());
    return service;
  }

  private Service registrar(
      BootstrapLoader loader, GroupDescription group, RegistrarDescription registrar)
      throws ActivationException, IOException {
    Path folder = phoenix.state().resolve("registrars");
    Files.createDirectories(folder);
    List<String> arguments = new ArrayList<>();
    arguments.add(RobotBootstrap.class.getResource("registrar.config").toString());
    override(arguments, "host", PhoenixProcess.quote(host));
    override(arguments, "initialUnicastDiscoveryPort", Integer.toString(registrar.port()));
    override(
        arguments,
        "persistenceDirectory",
        PhoenixProcess.quote(folder.resolve(robot.name()).toString()));
    override(arguments, "initialMemberGroups", array(robot.lookupGroups()));
    if (multicastGroups().isEmpty()) {
      override(arguments, "multicastInterfaces", "new java.net.NetworkInterface[]{}");
    }
    return loader.registrar(
        group, registrar, new MarshalledObject<>(arguments.toArray(String[]::new)));
  }

  /** The robot's own registrar is joined by unicast too: its modules need no multicast for it. */
  private List<String> locators() {
    List<String> locators = new ArrayList<>(robot.locators());
    robot
        .registrar()
        .filter(registrar -> registrar.port() != 0)
        .map(registrar -> "jini://" + host + ":" + registrar.port())
        .filter(own -> !locators.contains(own))
        .ifPresent(locators::add);
    return locators;
  }

  /** None where the robot is on the loopback: nobody elsewhere could reach what was announced. */
  private List<String> multicastGroups() {
    return HostAddress.isLoopback(host) ? List.of() : robot.lookupGroups();
  }

  private static void override(List<String> arguments, String entry, String expression) {
    arguments.add("com.sun.jini.reggie." + entry + "=" + expression);
  }

  private static String array(List<String> texts) {
    return "new String[]{"
        + String.join(",", texts.stream().map(PhoenixProcess::quote).toList())
        + "}";
  }
}
