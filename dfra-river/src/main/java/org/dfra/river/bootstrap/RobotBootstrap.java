package org.dfra.river.bootstrap;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationID;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.stream.Collectors;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.RegistrarDescription;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotDescription.GroupDescription;
import org.dfra.river.bootstrap.EmbeddedRobot.LookupSettings;
import org.dfra.river.loading.RobotCodebase;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleIdentity;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Brings a robot up under a running phoenix: its registrar first, then its modules.
 *
 * <p>Repeating it is safe: registered services keep their identity and are restarted only if their
 * description has changed. Services that are no longer described end.
 */
public final class RobotBootstrap {

  private static final Logger LOG = LoggerFactory.getLogger(RobotBootstrap.class);

  /** The time limit for bringing up a robot; until then, calls are retried. */
  private static final Duration TIME = Duration.ofSeconds(60);

  /** The time limit for the end of one module; its driver brakes first. */
  private static final Duration END = Duration.ofSeconds(15);

  private final PhoenixProcess phoenix;
  private final RobotDescription robot;
  private final String host;
  private final LookupSettings places;
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
        LookupSettings.of(robot, host, robot.registrar().map(RegistrarDescription::port).orElse(0));
    this.registrar = new RobotRegistrar(robot, host, !places.groups().isEmpty(), phoenix.state());
  }

  /**
   * A service that was brought up.
   *
   * @param name {@code robot/module}, or {@code robot/registrar}
   * @param group name of its service group
   * @param id its activation ID
   */
  public record ServiceReference(String name, String group, ActivationID id) {}

  /** As {@link #up(BringUpStep.Listener)}, without reports of the steps. */
  public List<ServiceReference> up() throws ActivationException, IOException {
    return up(step -> {});
  }

  /**
   * Makes the running robot match the description: registers and activates everything, restarts
   * services whose description changed, and ends services that are no longer described.
   *
   * @param listener is called after each step
   * @return the running services, the registrar first
   * @throws ConfigurationException if another robot of this phoenix has the registrar's port, or a
   *     host of its administrators is unknown; nothing was changed
   * @throws ActivationException if a service cannot be registered or activated, or the end of a
   *     module that must end is not confirmed; services that were already brought up keep running
   */
  public List<ServiceReference> up(BringUpStep.Listener listener)
      throws ActivationException, IOException {
    Optional<RobotCodebase> classes = codebase();
    if (classes.isPresent()) {
      classes.get().check();
    }
    RetryDeadline patience = RetryDeadline.of(TIME);
    if (robot.registrar().isPresent()) {
      PortUse.ofOthers(phoenix.admin(), robot.name(), patience)
          .requireFree(robot.name(), host, robot.registrar().get());
    }
    BootstrapLoader loader = loader(patience);
    String unused = loader.administrators(); // reports errors in them first
    robot.registrar().ifPresent(AddressRangeResolver::resolve);
    RobotDescriptionStore known = new RobotDescriptionStore(phoenix.state());
    boolean wasKnown = known.contains(robot.name());
    known.save(robot);
    BuildCopyUsage.recordUse(phoenix.state()); // before its journal names them
    try {
      PhoenixClient calls = PhoenixClient.to(phoenix);
      return new BringUp(calls, robot, loader, registrar, settings(), patience, listener).run();
    } catch (ActivationException | IOException | RuntimeException e) {
      if (!wasKnown) {
        forgetUnlessRegistered(known, loader, e);
      }
      throw e;
    }
  }

  /**
   * Deletes the robot's description if nothing of the robot is registered, so that it is no longer
   * looked up here.
   */
  private void forgetUnlessRegistered(
      RobotDescriptionStore known, BootstrapLoader loader, Exception failure) {
    try {
      if (loader.registeredGroups().isEmpty()) {
        known.delete(robot.name());
      }
    } catch (ActivationException | IOException e) {
      failure.addSuppressed(e); // it stays stored
    }
  }

  private BringUp.ModuleSettings settings() {
    return new BringUp.ModuleSettings() {
      @Override
      public ModuleActivation activationData(ModuleDescription module, ModuleIdentity identity) {
        return activation(module, identity);
      }

      @Override
      public Path stateFolder(ModuleDescription module) {
        return RobotBootstrap.moduleStateFolder(phoenix.state(), robot.name(), module.name());
      }
    };
  }

  private ModuleActivation activation(ModuleDescription module, ModuleIdentity identity) {
    return new ModuleActivation(
        module,
        identity.id(),
        identity.created(),
        host,
        places.groups(),
        places.locators(),
        moduleStateFolder(phoenix.state(), robot.name(), module.name()).toString());
  }

  /** Identities of the robot's modules that are registered with this phoenix. */
  public Set<UUID> identities() throws ActivationException, IOException {
    return loader(RetryDeadline.of(TIME)).modules().stream()
        .map(each -> each.activation().id())
        .collect(Collectors.toSet());
  }

  /** The address or name of this host that the robot's proxies carry. */
  public String host() {
    return host;
  }

  /**
   * The other robot of this phoenix that has the port of this one's class server, as a clause;
   * empty if there is none.
   */
  public Optional<String> classServerPortConflict() throws ActivationException, IOException {
    int port = robot.registrar().map(RegistrarDescription::classServerPort).orElse(0);
    return PortUse.ofOthers(phoenix.admin(), robot.name(), RetryDeadline.of(TIME))
        .of(host, port)
        .map(PortUse.UsedPort::describe);
  }

  /**
   * The jars that the robot serves to clients without its classes. Empty if it runs no class
   * server, or there is nothing to serve.
   *
   * @throws IOException if DFRA's own jars are missing
   */
  public Optional<RobotCodebase> codebase() throws IOException {
    return DownloadJars.of(robot, host, phoenix.state());
  }

  /** The folder for a module's state that outlives its virtual machine. */
  static Path moduleStateFolder(Path state, String robot, String module) {
    return state.toAbsolutePath().resolve("modules").resolve(robot).resolve(module);
  }

  private BootstrapLoader loader(RetryDeadline patience) throws IOException {
    return new BootstrapLoader(
        PhoenixClient.to(phoenix), robot.name(), robot.administration(), codebase(), patience);
  }

  /**
   * Adds a module to the running robot and activates it. It stays until it is removed, also when
   * phoenix and the robot restart.
   *
   * @param group name of one of the robot's service groups
   * @throws ConfigurationException if the robot has a module of that name or no such group
   * @throws ActivationException if it cannot be registered or activated
   */
  public ServiceReference add(ModuleDescription module, String group)
      throws ActivationException, IOException {
    RetryDeadline patience = RetryDeadline.of(TIME);
    BootstrapLoader loader = loader(patience);
    for (RegisteredGroup.RegisteredModule known : loader.modules()) {
      if (known.name().equals(module.name())) {
        throw new ConfigurationException(
            module.place()
                + ": there is a module "
                + module.path()
                + " already, in group "
                + known.group()
                + "; replace it, or rename one of the two");
      }
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
    endForgotten(patience);
    BuildCopyUsage.recordUse(phoenix.state());
    Path folder = moduleStateFolder(phoenix.state(), robot.name(), module.name());
    ModuleIdentity identity = ModuleIdentity.load(folder).orElseGet(ModuleIdentity::fresh);
    identity.store(folder);
    ActivationID id =
        loader.registerModule(loader.registerGroup(home), group, activation(module, identity));
    ServiceReference service = new ServiceReference(module.path(), group, id);
    ServiceStart.activate(service, module.place(), patience);
    return service;
  }

  /**
   * Starts a module that was stopped or has crashed; does nothing if it runs.
   *
   * @param module name of the module
   * @throws ConfigurationException if the robot has no module of that name
   * @throws ActivationException if it cannot be activated
   */
  public void start(String module) throws ActivationException, IOException {
    RetryDeadline patience = RetryDeadline.of(TIME);
    RegisteredGroup.RegisteredModule known = known(loader(patience), module, "start");
    endForgotten(patience);
    keep(known);
    ServiceStart.activate(
        new ServiceReference(robot.name() + "/" + module, known.group(), known.id()),
        known.activation().module().place(),
        patience);
  }

  /**
   * Replaces a module of the running robot according to the new description, for example with a
   * newer driver. It keeps its identity, so existing proxies reach the new one.
   *
   * @throws ConfigurationException if the robot has no module of that name
   * @throws ActivationException if it cannot be registered or activated
   */
  public ServiceReference replace(ModuleDescription module)
      throws ActivationException, IOException {
    RetryDeadline patience = RetryDeadline.of(TIME);
    BootstrapLoader loader = loader(patience);
    RegisteredGroup.RegisteredModule old = known(loader, module.name(), "replace");
    requireOwn(module);
    endForgotten(patience);
    ModuleIdentity identity = keep(old);
    ActivationID id =
        loader.registerModule(old.groupId(), old.group(), activation(module, identity));
    new ModuleTerminator(phoenix.admin(), END).deactivate(old);
    ServiceReference service = new ServiceReference(module.path(), old.group(), id);
    ServiceStart.activate(service, module.place(), patience);
    return service;
  }

  /**
   * Removes a module from the running robot: it leaves the lookup services, its device is closed,
   * and the activation system unregisters it.
   *
   * @param module name of the module
   * @throws ConfigurationException if the robot has no module of that name
   */
  public void remove(String module) throws ActivationException, IOException {
    RegisteredGroup.RegisteredModule old = known(loader(RetryDeadline.of(TIME)), module, "remove");
    new ModuleTerminator(phoenix.admin(), END).forget(old);
    LOG.info("{}/{} is removed from group {}.", robot.name(), module, old.group());
  }

  /** Stores the module's identity where the robot's other modules look it up to recognise it. */
  private ModuleIdentity keep(RegisteredGroup.RegisteredModule module) throws IOException {
    ModuleActivation activation = module.activation();
    ModuleIdentity identity = new ModuleIdentity(activation.id(), activation.created());
    identity.store(moduleStateFolder(phoenix.state(), robot.name(), module.name()));
    return identity;
  }

  /**
   * Runs before a driver is started: a service that is no longer registered may have its device.
   */
  private void endForgotten(RetryDeadline patience) throws ActivationException, IOException {
    new OrphanedServiceCleanup(new GroupTerminator(PhoenixClient.to(phoenix), patience))
        .terminateProcesses(
            robot.name(),
            step ->
                LOG.warn(
                    "The process of group {} was ended: it had {} that phoenix had forgotten.",
                    step.name(),
                    step.detail().equals("1") ? "a service" : step.detail() + " services"));
  }

  private void requireOwn(ModuleDescription module) {
    if (!module.robot().equals(robot.name())) {
      throw new ConfigurationException(
          module.place() + ": module " + module.path() + " is not of robot " + robot.name());
    }
  }

  private RegisteredGroup.RegisteredModule known(BootstrapLoader loader, String module, String what)
      throws ActivationException, IOException {
    List<RegisteredGroup.RegisteredModule> modules = loader.modules();
    return modules.stream()
        .filter(each -> each.name().equals(module))
        .findFirst()
        .orElseThrow(
            () ->
                new ConfigurationException(
                    "there is no module "
                        + robot.name()
                        + "/"
                        + module
                        + " to "
                        + what
                        + "; the robot has "
                        + modules.stream()
                            .map(RegisteredGroup.RegisteredModule::name)
                            .sorted()
                            .toList()));
  }
}
