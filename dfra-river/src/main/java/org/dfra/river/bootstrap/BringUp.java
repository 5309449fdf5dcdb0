package org.dfra.river.bootstrap;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.RegistrarDescription;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotDescription.GroupDescription;
import org.dfra.river.bootstrap.BringUpStep.Kind;
import org.dfra.river.bootstrap.RobotBootstrap.ServiceReference;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.river.phoenix.PhoenixAdmin;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleIdentity;
import org.jspecify.annotations.Nullable;

/**
 * Brings a robot up once: changes the registered and running services to match the description.
 *
 * <p>Removals come first: a module that is no longer described, or is described in another group,
 * ends before anything starts, and so does each module whose description changed. Otherwise two
 * drivers could control the same motor. If the end of one of them is not confirmed, only services
 * with an unchanged description are started. Failures of single modules are thrown at the end.
 */
final class BringUp {

  /** The time limit for the end of one module or process; drivers brake first. */
  private static final Duration END = Duration.ofSeconds(15);

  private final PhoenixAdmin admin;
  private final RobotDescription robot;
  private final BootstrapLoader loader;
  private final RobotRegistrar registrar;
  private final ModuleSettings settings;
  private final RetryDeadline patience;
  private final BringUpStep.Listener listener;
  private final ModuleTerminator moduleEnd;
  private final GroupTerminator groupEnd;
  private final Map<String, RegisteredGroup.RegisteredModule> moved = new HashMap<>();
  private final Map<String, NotEndedException> notEnded = new TreeMap<>();
  private final List<Exception> failures = new ArrayList<>(); // of other modules
  private List<RegisteredGroup> before = List.of();

  /** The activation settings of a module, for a robot on a host. */
  interface ModuleSettings {
    ModuleActivation activationData(ModuleDescription module, ModuleIdentity identity);

    /** The folder for state that outlives the module's virtual machine. */
    Path stateFolder(ModuleDescription module);
  }

  BringUp(
      PhoenixClient phoenix,
      RobotDescription robot,
      BootstrapLoader loader,
      RobotRegistrar registrar,
      ModuleSettings settings,
      RetryDeadline patience,
      BringUpStep.Listener listener)
      throws RemoteException {
    this.admin = phoenix.admin();
    this.robot = robot;
    this.loader = loader;
    this.registrar = registrar;
    this.settings = settings;
    this.patience = patience;
    this.listener = listener;
    this.moduleEnd = new ModuleTerminator(admin, END);
    this.groupEnd = new GroupTerminator(phoenix, patience);
  }

  /**
   * Runs all bring-up steps.
   *
   * @return the running services, the registrar first
   * @throws ActivationException if modules did not start, or their end is not confirmed; the
   *     message names the modules and the causes
   */
  List<ServiceReference> run() throws ActivationException, IOException {
    before = loader.registeredGroups();
    Map<String, Long> processes = incarnations();
    for (GroupDescription group : robot.groups()) {
      if (before(group.name()).isPresent()) { // a restarted process starts as described
        ActivationGroupID unused = loader.registerGroup(group);
      }
    }
    for (RegisteredGroup group : before) {
      removeUndescribed(group);
    }
    new OrphanedServiceCleanup(groupEnd).terminateProcesses(robot.name(), listener);
    List<ServiceReference> services = start();
    try {
      reportStaleGroups(processes);
    } catch (ActivationException | IOException e) {
      failures.add(e);
    }
    throwFailures();
    return services;
  }

  private List<ServiceReference> start() throws ActivationException, IOException {
    List<ServiceReference> services = new ArrayList<>();
    // The registrar first, so that the modules find it when they start.
    for (GroupDescription group : robot.groups()) {
      if (group.registrar().isPresent()) {
        services.add(registrar(group, group.registrar().get()));
      }
    }
    // Everything that has to end does so before anything starts that may need its device.
    List<Ready> all = new ArrayList<>();
    for (GroupDescription group : robot.groups()) {
      ActivationGroupID groupId = loader.registerGroup(group);
      for (ModuleDescription module : group.modules()) {
        if (!notEnded.containsKey(module.name())) {
          try {
            all.add(ready(groupId, group.name(), module));
          } catch (NotEndedException e) { // it keeps running with its old description
            notEnded.put(module.name(), e);
          } catch (ActivationException | IOException e) {
            failures.add(e);
          }
        }
      }
    }
    for (Ready each : all) {
      try {
        start(each);
        services.add(each.service());
      } catch (ActivationException | IOException e) {
        failures.add(e);
      }
    }
    return services;
  }

  private void start(Ready ready) throws ActivationException, IOException {
    ServiceReference service = ready.service();
    if (ready.isOther() && !notEnded.isEmpty()) {
      groupEnd.unregister(service.id()); // or a call would start it
      throw new ActivationException(
          ready.module().place()
              + ": "
              + service.name()
              + " is not started: what did not end may have its device; when that has ended, bring"
              + " the robot up again");
    }
    ServiceStart.activate(service, ready.module().place(), patience);
    step(service.name(), service.group(), ready.kind(), ready.detail());
  }

  /** Throws all failures of single modules. */
  private void throwFailures() throws ActivationException, IOException {
    List<Exception> all = new ArrayList<>(notEnded.values());
    all.addAll(failures);
    if (all.size() == 1 && all.get(0) instanceof IOException failure) {
      throw failure;
    }
    if (!all.isEmpty()) {
      throw new ActivationException(
          all.stream().map(Exception::getMessage).distinct().collect(Collectors.joining("; ")));
    }
  }

  /** The number of process starts of each of the robot's groups that has a process. */
  private Map<String, Long> incarnations() throws ActivationException, IOException {
    return patience.call(admin::groupStatus).stream()
        .filter(each -> each.pid() >= 0)
        .collect(
            Collectors.toMap(
                each -> GroupTerminator.plain(each.name()),
                GroupStatus::incarnation,
                (one, other) -> one));
  }

  /**
   * Reports groups whose description changed but whose process was not restarted: it keeps its
   * options until it ends, and other modules run in it.
   */
  private void reportStaleGroups(Map<String, Long> then) throws ActivationException, IOException {
    Map<String, Long> now = incarnations();
    for (GroupDescription group : robot.groups()) {
      String name = fullName(group.name());
      boolean isChanged =
          before(group.name()).filter(old -> !old.desc().equals(loader.desc(group))).isPresent();
      if (isChanged && now.containsKey(name) && now.get(name).equals(then.get(name))) {
        reportGroup(Kind.GROUP_STALE, group.name(), "");
      }
    }
  }

  private Optional<GroupDescription> described(String group) {
    return robot.groups().stream().filter(each -> each.name().equals(group)).findFirst();
  }

  /** The name of the group that the description has a module in; null if there is none. */
  private @Nullable String describedGroup(String module) {
    return robot.groups().stream()
        .filter(group -> group.modules().stream().anyMatch(each -> each.name().equals(module)))
        .map(GroupDescription::name)
        .findFirst()
        .orElse(null);
  }

  /** Ends the services of a group that the description does not have in it. */
  private void removeUndescribed(RegisteredGroup group) throws ActivationException, IOException {
    boolean isEmpty = true;
    for (RegisteredGroup.RegisteredModule module : group.modules()) {
      @Nullable String home = describedGroup(module.name());
      if (!group.name().equals(home)) {
        isEmpty &= removeUndescribed(module, home);
      }
    }
    Optional<GroupDescription> described = described(group.name());
    boolean isHome = described.flatMap(GroupDescription::registrar).isPresent();
    if (group.registrar().isPresent() && !isHome) {
      groupEnd.unregister(group.registrar().get().id());
      if (described.isPresent()) { // reggie cannot end without losing its state
        groupEnd.restart(fullName(group.name()), END);
        reportGroup(Kind.GROUP_RESTARTED, group.name(), "the registrar has left it");
      }
    }
    if (described.isEmpty() && isEmpty) {
      groupEnd.terminate(fullName(group.name()), END);
      groupEnd.unregister(group.id());
      reportGroup(Kind.GROUP_ENDED, group.name(), "");
    }
  }

  /** Ends a module permanently; returns false if its end is not confirmed. */
  private boolean removeUndescribed(RegisteredGroup.RegisteredModule module, @Nullable String home)
      throws ActivationException, IOException {
    try {
      moduleEnd.forget(module);
    } catch (NotEndedException e) {
      notEnded.put(module.name(), e);
      return false;
    }
    boolean isThere =
        home != null && before(home).flatMap(g -> g.module(module.name())).isPresent();
    if (home != null && !isThere) {
      moved.putIfAbsent(module.name(), module);
    } else {
      step(module.activation().module().path(), module.group(), Kind.ENDED, "");
    }
    return true;
  }

  private String fullName(String group) {
    return robot.name() + "." + group;
  }

  private Optional<RegisteredGroup> before(String group) {
    return before.stream().filter(each -> each.name().equals(group)).findFirst();
  }

  private ServiceReference registrar(GroupDescription group, RegistrarDescription description)
      throws ActivationException, IOException {
    Optional<RegisteredGroup.RegisteredRegistrar> old =
        before(group.name()).flatMap(RegisteredGroup::registrar);
    boolean wasActive =
        old.isPresent() && isActive(before(group.name()).get().id(), old.get().id());
    String[] arguments = registrar.arguments(description);
    ActivationID id =
        loader.registerRegistrar(group, description, new MarshalledObject<>(arguments));
    ServiceReference service = new ServiceReference(robot.name() + "/registrar", group.name(), id);
    boolean isChanged =
        wasActive
            && !RegistrarArguments.startupOnly(List.of(arguments))
                .equals(RegistrarArguments.startupOnly(old.get().arguments()));
    if (isChanged) {
      groupEnd.restart(fullName(group.name()), END);
      reportGroup(
          Kind.GROUP_RESTARTED,
          group.name(),
          "the registrar's host, folder or module hosts have changed");
    }
    try {
      registrar.start(service, description, patience);
    } catch (ActivationException e) {
      if (old.isEmpty()) {
        withdraw(service, before(group.name()).isEmpty());
      }
      throw e;
    }
    step(
        service.name(),
        group.name(),
        isChanged ? Kind.RESTARTED : wasActive ? Kind.UNCHANGED : Kind.STARTED,
        "");
    return service;
  }

  /** Unregisters a service that did not start, so that it is not listed as available. */
  private void withdraw(ServiceReference service, boolean withGroup)
      throws ActivationException, IOException {
    groupEnd.unregister(service.id());
    Optional<RegisteredGroup> group =
        loader.registeredGroups().stream()
            .filter(each -> each.name().equals(service.group()))
            .findFirst();
    if (withGroup && group.isPresent()) {
      groupEnd.terminate(fullName(service.group()), END);
      groupEnd.unregister(group.get().id());
    }
  }

  private boolean isActive(ActivationGroupID group, ActivationID object)
      throws ActivationException, IOException {
    return patience.call(() -> admin.activeObjects(group)).contains(object);
  }

  /**
   * A module that is registered as described and whose former version has ended.
   *
   * @param isOther whether its former description or group was different
   */
  private record Ready(
      ServiceReference service,
      ModuleDescription module,
      boolean isOther,
      Kind kind,
      String detail) {}

  private Ready ready(ActivationGroupID groupId, String group, ModuleDescription module)
      throws ActivationException, IOException {
    Optional<RegisteredGroup.RegisteredModule> here =
        before(group).flatMap(old -> old.module(module.name()));
    ModuleActivation activation = settings.activationData(module, identity(module, here));
    List<String> changes =
        here.map(old -> ActivationChanges.between(old.activation(), activation)).orElse(List.of());
    boolean wasActive = here.isPresent() && isActive(groupId, here.get().id());
    ActivationID id = loader.registerModule(groupId, group, activation);
    if (here.isPresent() && !changes.isEmpty()) {
      try {
        moduleEnd.deactivate(here.get()); // a call may have started it with the old description
      } catch (NotEndedException e) {
        loader.registerModule(groupId, group, here.get().activation()); // it keeps running as this
        throw e;
      }
    }
    String detail =
        moved.containsKey(module.name())
            ? moved.get(module.name()).group()
            : String.join(", ", changes);
    return new Ready(
        new ServiceReference(module.path(), group, id),
        module,
        here.isEmpty() || !changes.isEmpty(),
        kind(module.name(), wasActive, changes),
        detail);
  }

  private Kind kind(String module, boolean wasActive, List<String> changes) {
    if (moved.containsKey(module)) {
      return Kind.MOVED;
    }
    return !wasActive ? Kind.STARTED : changes.isEmpty() ? Kind.UNCHANGED : Kind.RESTARTED;
  }

  /** Keeps the module's identity from any group, or from before the robot was taken down. */
  private ModuleIdentity identity(
      ModuleDescription module, Optional<RegisteredGroup.RegisteredModule> here)
      throws IOException {
    Path folder = settings.stateFolder(module);
    ModuleIdentity identity =
        here.or(() -> Optional.ofNullable(moved.get(module.name())))
            .map(old -> new ModuleIdentity(old.activation().id(), old.activation().created()))
            .or(() -> ModuleIdentity.load(folder))
            .orElseGet(ModuleIdentity::fresh);
    identity.store(folder);
    return identity;
  }

  private void reportGroup(Kind kind, String group, String detail) {
    step(fullName(group), group, kind, detail);
  }

  private void step(String name, String group, Kind kind, String detail) {
    listener.onStep(new BringUpStep(name, group, kind, detail));
  }
}
