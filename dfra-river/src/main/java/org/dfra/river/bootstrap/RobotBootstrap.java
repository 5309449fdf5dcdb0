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
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import net.jini.lookup.DiscoveryAdmin;
import org.dfra.core.config.GroupDescription;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Place;
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

  /** How a group begins to tell that a constructor threw something. */
  private static final Pattern THROWN =
      Pattern.compile("[\\w.$]+: its constructor failed: [\\w.$]+(?:Exception|Error): ");

  /** How a group begins to tell that there is no such class. */
  private static final Pattern MISSING =
      Pattern.compile("([\\w.$]+): its class is not on the group's class path: ");

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
        services.add(bringUp(loader, group, group.registrar().get()));
      }
    }
    // Steps 4 to 8: the modules. Their XML and properties were read with the robot's description.
    for (GroupDescription group : robot.groups()) {
      ActivationGroupID groupId = loader.group(group);
      for (ModuleDescription module : group.modules()) {
        services.add(
            activate(
                loader.module(groupId, group, module, host, locators(), multicastGroups()),
                module.place()));
      }
    }
    return services;
  }

  private static Service activate(Service service, Place place)
      throws ActivationException, RemoteException {
    try {
      service.id().activate(false);
    } catch (ActivationException e) {
      // Without the cause: an activation exception's message repeats its cause's.
      String known = place + ": module " + service.name() + ": ";
      throw new ActivationException(
          place + ": " + service.name() + " did not start: " + reason(e).replace(known, ""));
    }
    LOG.info("{} is up in group {}.", service.name(), service.group());
    return service;
  }

  private Service bringUp(
      BootstrapLoader loader, GroupDescription group, RegistrarDescription description)
      throws ActivationException, IOException {
    Service service = activate(registrar(loader, group, description), description.place());
    try {
      settle((DiscoveryAdmin) service.id().activate(false), description);
      return service;
    } catch (IOException e) {
      throw new IOException(description.place() + ": " + service.name() + ": " + e.getMessage(), e);
    }
  }

  /** Reggie reads its port and groups only once in its life; what changed since is told to it. */
  private void settle(DiscoveryAdmin registrar, RegistrarDescription description)
      throws IOException {
    if (description.port() != 0 && registrar.getUnicastPort() != description.port()) {
      registrar.setUnicastPort(description.port());
    }
    Set<String> groups = Set.copyOf(robot.lookupGroups());
    if (!groups.equals(Set.copyOf(Arrays.asList(registrar.getMemberGroups())))) {
      registrar.setMemberGroups(groups.toArray(String[]::new));
    }
  }

  /**
   * Why something did not start, without the names of the classes in which that happened; these are
   * in the group's log.
   */
  private static String reason(ActivationException failure) {
    String message = String.valueOf(failure.getMessage());
    Matcher missing = MISSING.matcher(message);
    if (missing.lookingAt()) {
      return "server class "
          + missing.group(1)
          + " is not on the group's class path; add its jar or mend the name";
    }
    Matcher thrown = THROWN.matcher(message);
    return thrown.lookingAt() ? message.substring(thrown.end()) : message;
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
    if (multicastGroups().isEmpty()) { // neither to announce itself nor to listen for others
      String none = "multicastInterfaces=new java.net.NetworkInterface[]{}";
      arguments.add("com.sun.jini.reggie." + none);
      arguments.add("net.jini.discovery.LookupDiscovery." + none);
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
