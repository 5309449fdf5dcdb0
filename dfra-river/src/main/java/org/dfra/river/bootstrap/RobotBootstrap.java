package org.dfra.river.bootstrap;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.GroupDescription;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.RegistrarDescription;
import org.dfra.core.config.RobotDescription;
import org.dfra.river.loading.RobotClasses;
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

  private final PhoenixProcess phoenix;
  private final RobotDescription robot;
  private final String host;
  private final LookupPlaces places;
  private final RobotRegistrar registrar;

  /**
   * @param phoenix the phoenix of this host
   * @param robot the robot's description
   */
  public RobotBootstrap(PhoenixProcess phoenix, RobotDescription robot) {
    this.phoenix = phoenix;
    this.robot = robot;
    this.host = HostAddress.resolve(robot.host());
    this.places =
        LookupPlaces.of(robot, host, robot.registrar().map(RegistrarDescription::port).orElse(0));
    this.registrar = new RobotRegistrar(robot, host, !places.groups().isEmpty(), phoenix.state());
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
    LaunchedJars.keepFor(phoenix.state()); // before its journal names them
    List<Service> services = new ArrayList<>();
    BootstrapLoader loader = loader();
    // Steps 2 and 3: the registrar, so that the modules find it when they start.
    for (GroupDescription group : robot.groups()) {
      if (group.registrar().isPresent()) {
        services.add(registrar.bringUp(loader, group, group.registrar().get()));
      }
    }
    // Steps 4 to 8: the modules. Their XML and properties were read with the robot's description.
    for (GroupDescription group : robot.groups()) {
      ActivationGroupID groupId = loader.group(group);
      for (ModuleDescription module : group.modules()) {
        Service service = register(loader, groupId, group.name(), module);
        ServiceStart.of(service, module.place());
        services.add(service);
      }
    }
    return services;
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

  private Service register(
      BootstrapLoader loader, ActivationGroupID groupId, String group, ModuleDescription module)
      throws ActivationException, IOException {
    return loader.module(
        groupId,
        group,
        module,
        host,
        places.locators(),
        places.groups(),
        folder(phoenix.state(), robot.name(), module.name()));
  }

  /** Where a module keeps what outlives its virtual machine. */
  static Path folder(Path state, String robot, String module) {
    return state.toAbsolutePath().resolve("modules").resolve(robot).resolve(module);
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
    LaunchedJars.keepFor(phoenix.state());
    Service service = register(loader, loader.group(home), group, module);
    ServiceStart.of(service, module.place());
    return service;
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
    ServiceStart.of(
        new Service(robot.name() + "/" + module, known.group(), known.id()),
        known.activation().module().place());
  }

  /**
   * The server of a module, for whoever cannot wait for a lookup service. It is started where it
   * does not run.
   *
   * @param module name of the module
   * @throws ConfigurationException if the robot has no module of that name
   * @throws ActivationException if it cannot be activated
   */
  public RemoteModule reach(String module) throws ActivationException, IOException {
    return (RemoteModule) known(loader(), module, "reach").id().activate(false);
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
    RunningModule running = RunningModule.of(old);
    Service service = register(loader, old.groupId(), old.group(), module);
    running.deactivate();
    ServiceStart.of(service, module.place());
    return service;
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
    RunningModule running = RunningModule.of(old);
    phoenix.system().unregisterObject(old.id());
    running.destroy();
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
}
