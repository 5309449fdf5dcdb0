package org.dfra.river.bootstrap;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.ConnectException;
import java.rmi.MarshalledObject;
import java.rmi.NoSuchObjectException;
import java.rmi.RemoteException;
import java.rmi.UnmarshalException;
import java.rmi.activation.ActivateFailedException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import net.jini.admin.JoinAdmin;
import net.jini.core.entry.Entry;
import net.jini.lookup.DiscoveryAdmin;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.GroupDescription;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Place;
import org.dfra.core.config.RegistrarDescription;
import org.dfra.core.config.RobotDescription;
import org.dfra.river.entry.Entries;
import org.dfra.river.entry.PersonaEntry;
import org.dfra.river.loading.RobotClasses;
import org.dfra.river.remote.ModuleAdmin;
import org.dfra.river.remote.RemoteModule;
import org.jspecify.annotations.Nullable;
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
    Optional<RobotClasses> classes = classes();
    if (classes.isPresent()) {
      classes.get().check();
    }
    new KnownRobots(phoenix.state()).remember(robot);
    List<Service> services = new ArrayList<>();
    BootstrapLoader loader = loader();
    // Steps 2 and 3: the registrar, so that the modules find it when they start.
    for (GroupDescription group : robot.groups()) {
      if (group.registrar().isPresent()) {
        Service registrar = bringUp(loader, group, group.registrar().get());
        showPersona(registrar);
        services.add(registrar);
      }
    }
    // Steps 4 to 8: the modules. Their XML and properties were read with the robot's description.
    for (GroupDescription group : robot.groups()) {
      ActivationGroupID groupId = loader.group(group);
      for (ModuleDescription module : group.modules()) {
        services.add(
            activate(
                loader.module(
                    groupId,
                    group.name(),
                    module,
                    host,
                    locators(),
                    multicastGroups(),
                    state(module)),
                module.place()));
      }
    }
    return services;
  }

  /**
   * Attaches the robot's persona to its registrar, in place of an older one. The registrar keeps it
   * in its own log, so it is there again after every restart.
   */
  private void showPersona(Service registrar) throws ActivationException, IOException {
    JoinAdmin admin =
        (JoinAdmin) registrar.id().activate(false); // reggie's remote interface is one
    Entry[] old =
        Arrays.stream(admin.getLookupAttributes())
            .filter(PersonaEntry.class::isInstance)
            .toArray(Entry[]::new);
    Entry[] wanted = robot.persona().map(each -> Entries.of(List.of(each))).orElse(new Entry[0]);
    if (Arrays.equals(old, wanted)) {
      return;
    }
    if (old.length > 0) {
      admin.modifyLookupAttributes(old, new Entry[old.length]); // null takes it out
    }
    if (wanted.length > 0) {
      admin.addLookupAttributes(wanted);
    }
  }

  /**
   * What the robot serves to clients that lack its classes. Empty if it runs no class server, or
   * there is nothing to serve.
   *
   * @throws IOException if DFRA's own jars are not where they should be
   */
  public Optional<RobotClasses> classes() throws IOException {
    return DownloadJars.of(robot, host, phoenix.state());
  }

  /** Where the module keeps what outlives its virtual machine. */
  private Path state(ModuleDescription module) {
    return phoenix
        .state()
        .toAbsolutePath()
        .resolve("modules")
        .resolve(robot.name())
        .resolve(module.name());
  }

  private BootstrapLoader loader() throws IOException {
    return new BootstrapLoader(phoenix.admin(), phoenix.system(), robot.name(), classes());
  }

  /**
   * Adds a module to the running robot and activates it. It stays until it is removed, also when
   * phoenix and the robot start again.
   *
   * @param group name of one of the robot's service groups
   * @throws ConfigurationException if the robot has a module of that name or no such group
   * @throws ActivationException if it cannot be registered or activated
   */
  public Service add(ModuleDescription module, String group)
      throws ActivationException, IOException {
    BootstrapLoader loader = loader();
    BootstrapLoader.@Nullable Registered known = loader.registered().get(module.name());
    if (known != null) {
      throw new ConfigurationException(
          module.place()
              + ": there is a module "
              + module.path()
              + " already, in group "
              + known.group()
              + "; replace it, or rename one of the two");
    }
    requireOwn(module);
    GroupDescription home =
        robot.groups().stream()
            .filter(each -> each.name().equals(group))
            .findFirst()
            .orElseThrow(
                () ->
                    new ConfigurationException(
                        module.place()
                            + ": robot "
                            + robot.name()
                            + " has no group "
                            + group
                            + "; it has "
                            + robot.groups().stream().map(GroupDescription::name).toList()));
    return activate(
        loader.module(
            loader.group(home), group, module, host, locators(), multicastGroups(), state(module)),
        module.place());
  }

  /**
   * Starts a module that was stopped or has crashed; nothing happens where it runs.
   *
   * @param module name of the module
   * @throws ConfigurationException if the robot has no module of that name
   * @throws ActivationException if it cannot be activated
   */
  public void start(String module) throws ActivationException, IOException {
    BootstrapLoader.Registered known = known(loader(), module, "start");
    activate(
        new Service(robot.name() + "/" + module, known.group(), known.id()),
        known.activation().module().place());
  }

  /**
   * Replaces a module of the running robot by what the new description says, such as a newer
   * driver. It keeps its identity, so whoever has its proxy goes on with the new one.
   *
   * @throws ConfigurationException if the robot has no module of that name
   * @throws ActivationException if it cannot be registered or activated
   */
  public Service replace(ModuleDescription module) throws ActivationException, IOException {
    BootstrapLoader loader = loader();
    BootstrapLoader.Registered old = known(loader, module.name(), "replace");
    requireOwn(module);
    Optional<ModuleAdmin> running = running(old);
    Service service =
        loader.module(
            old.groupId(), old.group(), module, host, locators(), multicastGroups(), state(module));
    end(running, ModuleAdmin::deactivate);
    return activate(service, module.place());
  }

  /**
   * Removes a module from the running robot: it leaves the lookup services, its device is closed,
   * and the activation system forgets it.
   *
   * @param module name of the module
   * @throws ConfigurationException if the robot has no module of that name
   */
  public void remove(String module) throws ActivationException, IOException {
    BootstrapLoader.Registered old = known(loader(), module, "remove");
    Optional<ModuleAdmin> running = running(old);
    phoenix.system().unregisterObject(old.id());
    end(running, ModuleAdmin::destroy);
    LOG.info("{}/{} is removed from group {}.", robot.name(), module, old.group());
  }

  private void requireOwn(ModuleDescription module) {
    if (!module.robot().equals(robot.name())) {
      throw new ConfigurationException(
          module.place() + ": module " + module.path() + " is not of robot " + robot.name());
    }
  }

  private BootstrapLoader.Registered known(BootstrapLoader loader, String module, String what)
      throws ActivationException, RemoteException {
    Map<String, BootstrapLoader.Registered> modules = loader.registered();
    BootstrapLoader.@Nullable Registered known = modules.get(module);
    if (known == null) {
      throw new ConfigurationException(
          "there is no module "
              + robot.name()
              + "/"
              + module
              + " to "
              + what
              + "; the robot has "
              + modules.keySet());
    }
    return known;
  }

  /** The administration of a module that runs; nothing where it cannot be brought to run. */
  private static Optional<ModuleAdmin> running(BootstrapLoader.Registered module)
      throws RemoteException {
    try {
      return Optional.of((ModuleAdmin) ((RemoteModule) module.id().activate(false)).getAdmin());
    } catch (ActivationException | ActivateFailedException e) {
      LOG.info("{} did not run: {}", module.activation().module().path(), e.getMessage());
      return Optional.empty();
    }
  }

  private interface Ending {
    void of(ModuleAdmin admin) throws RemoteException;
  }

  private static void end(Optional<ModuleAdmin> running, Ending ending) throws RemoteException {
    if (running.isPresent()) {
      try {
        ending.of(running.get());
      } catch (UnmarshalException | NoSuchObjectException | ConnectException e) {
        LOG.debug("The last module of a group took its virtual machine along.", e);
      }
    }
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
    String[] arguments =
        RegistrarArguments.of(
            host,
            registrar.port(),
            folder.resolve(robot.name()),
            robot.lookupGroups(),
            !multicastGroups().isEmpty());
    return loader.registrar(group, registrar, new MarshalledObject<>(arguments));
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
}
