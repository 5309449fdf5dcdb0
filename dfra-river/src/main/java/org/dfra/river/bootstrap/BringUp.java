package org.dfra.river.bootstrap;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.MarshalledObject;
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
import org.dfra.core.config.GroupDescription;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.RegistrarDescription;
import org.dfra.core.config.RobotDescription;
import org.dfra.river.bootstrap.BringUpStep.Kind;
import org.dfra.river.bootstrap.RobotBootstrap.Service;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.river.phoenix.PhoenixAdmin;
import org.dfra.river.server.ModuleActivation;
import org.jspecify.annotations.Nullable;

/**
 * One bringing up of a robot: makes what is registered and runs what the description says.
 *
 * <p>What has to go, goes first: a module that the description has in another group, or not at all,
 * has ended before anything is started. Otherwise two drivers could have one motor. A module whose
 * end is not proven is not started elsewhere; the others are, and then that is thrown.
 */
final class BringUp {

  /** How long the end of one module or process may take; drivers brake first. */
  private static final Duration END = Duration.ofSeconds(15);

  private final PhoenixAdmin admin;
  private final RobotDescription robot;
  private final BootstrapLoader loader;
  private final RobotRegistrar registrar;
  private final ModuleSettings settings;
  private final Patience patience;
  private final BringUpStep.Listener listener;
  private final ModuleEnd moduleEnd;
  private final GroupEnd groupEnd;
  private final Map<String, RegisteredGroup.Module> moved = new HashMap<>();
  private final Map<String, NotEndedException> notEnded = new TreeMap<>();
  private List<RegisteredGroup> before = List.of();

  /** What a module is activated with, for a robot on a host. */
  interface ModuleSettings {
    ModuleActivation of(ModuleDescription module, ModuleIdentity identity);

    /** Where the module keeps what outlives its virtual machine. */
    Path folder(ModuleDescription module);
  }

  BringUp(
      PhoenixProcess phoenix,
      RobotDescription robot,
      BootstrapLoader loader,
      RobotRegistrar registrar,
      ModuleSettings settings,
      Patience patience,
      BringUpStep.Listener listener) {
    this.admin = phoenix.admin();
    this.robot = robot;
    this.loader = loader;
    this.registrar = registrar;
    this.settings = settings;
    this.patience = patience;
    this.listener = listener;
    this.moduleEnd = new ModuleEnd(admin, END);
    this.groupEnd = new GroupEnd(phoenix, patience);
  }

  /**
   * Does it.
   *
   * @return what is up, the registrar first
   * @throws NotEndedException if all else is up, but the end of a module is not proven
   */
  List<Service> run() throws ActivationException, IOException {
    before = loader.registered();
    Map<String, Long> processes = incarnations();
    for (GroupDescription group : robot.groups()) {
      if (before(group.name())
          .isPresent()) { // a process that is restarted is to start as described
        ActivationGroupID unused = loader.group(group);
      }
    }
    for (RegisteredGroup group : before) {
      leave(group);
    }
    new ForgottenServices(groupEnd).end(robot.name(), listener);
    List<Service> services = start();
    sayWhatWasKept(processes);
    if (!notEnded.isEmpty()) {
      throw new ActivationException(
          notEnded.values().stream()
              .map(NotEndedException::getMessage)
              .collect(Collectors.joining("; ")));
    }
    return services;
  }

  private List<Service> start() throws ActivationException, IOException {
    List<Service> services = new ArrayList<>();
    // The registrar first, so that the modules find it when they start.
    for (GroupDescription group : robot.groups()) {
      if (group.registrar().isPresent()) {
        services.add(registrar(group, group.registrar().get()));
      }
    }
    // Whatever ends does so before anything starts, which may need its device.
    List<Ready> all = new ArrayList<>();
    for (GroupDescription group : robot.groups()) {
      ActivationGroupID groupId = loader.group(group);
      for (ModuleDescription module : group.modules()) {
        if (!notEnded.containsKey(module.name())) {
          try {
            all.add(ready(groupId, group.name(), module));
          } catch (NotEndedException e) { // it works on as it was described before
            notEnded.put(module.name(), e);
          }
        }
      }
    }
    services.addAll(start(all));
    return services;
  }

  /** One that does not start keeps no other that has ended for this from starting. */
  private List<Service> start(List<Ready> all) throws ActivationException, IOException {
    List<Service> services = new ArrayList<>();
    List<ActivationException> failures = new ArrayList<>();
    for (Ready each : all) {
      try {
        ServiceStart.of(each.service(), each.module().place(), patience);
        step(each.service().name(), each.service().group(), each.kind(), each.detail());
        services.add(each.service());
      } catch (ActivationException e) {
        failures.add(e);
      }
    }
    if (failures.size() == 1) {
      throw failures.get(0);
    }
    if (!failures.isEmpty()) {
      throw new ActivationException(
          failures.stream().map(Exception::getMessage).collect(Collectors.joining("; ")));
    }
    return services;
  }

  /** How often a process was started for each of the robot's groups that has one. */
  private Map<String, Long> incarnations() throws ActivationException, IOException {
    return patience.ask(admin::groupStatus).stream()
        .filter(each -> each.pid() >= 0)
        .collect(
            Collectors.toMap(
                each -> GroupEnd.plain(each.name()),
                GroupStatus::incarnation,
                (one, other) -> one));
  }

  /** A process has its options for life, and other modules that work in it. */
  private void sayWhatWasKept(Map<String, Long> then) throws ActivationException, IOException {
    Map<String, Long> now = incarnations();
    for (GroupDescription group : robot.groups()) {
      String name = fullName(group.name());
      boolean isChanged =
          before(group.name()).filter(old -> !old.desc().equals(loader.desc(group))).isPresent();
      if (isChanged && now.containsKey(name) && now.get(name).equals(then.get(name))) {
        say(Kind.GROUP_KEPT, group.name(), "");
      }
    }
  }

  private Optional<GroupDescription> described(String group) {
    return robot.groups().stream().filter(each -> each.name().equals(group)).findFirst();
  }

  /** The name of the group in which the description has a module; null if it has none. */
  private @Nullable String home(String module) {
    return robot.groups().stream()
        .filter(group -> group.modules().stream().anyMatch(each -> each.name().equals(module)))
        .map(GroupDescription::name)
        .findFirst()
        .orElse(null);
  }

  /** Ends what of a group the description does not have in it. */
  private void leave(RegisteredGroup group) throws ActivationException, IOException {
    boolean isEmpty = true;
    for (RegisteredGroup.Module module : group.modules()) {
      @Nullable String home = home(module.name());
      if (!group.name().equals(home)) {
        isEmpty &= leave(module, home);
      }
    }
    Optional<GroupDescription> described = described(group.name());
    boolean isHome = described.flatMap(GroupDescription::registrar).isPresent();
    if (group.registrar().isPresent() && !isHome) {
      groupEnd.unregister(group.registrar().get().id());
      if (described.isPresent()) { // reggie cannot be ended without its state
        groupEnd.restart(fullName(group.name()), END);
        say(Kind.GROUP_RESTARTED, group.name(), "the registrar has left it");
      }
    }
    if (described.isEmpty() && isEmpty) {
      groupEnd.end(fullName(group.name()), END);
      groupEnd.unregister(group.id());
      say(Kind.GROUP_ENDED, group.name(), "");
    }
  }

  /** Ends a module for good; false if that is not proven. */
  private boolean leave(RegisteredGroup.Module module, @Nullable String home)
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

  private Service registrar(GroupDescription group, RegistrarDescription description)
      throws ActivationException, IOException {
    Optional<RegisteredGroup.Registrar> old =
        before(group.name()).flatMap(RegisteredGroup::registrar);
    boolean wasActive =
        old.isPresent() && isActive(before(group.name()).get().id(), old.get().id());
    String[] arguments = registrar.arguments(description);
    ActivationID id = loader.registrar(group, description, new MarshalledObject<>(arguments));
    Service service = new Service(robot.name() + "/registrar", group.name(), id);
    boolean isChanged =
        wasActive
            && !RegistrarArguments.atStart(List.of(arguments))
                .equals(RegistrarArguments.atStart(old.get().arguments()));
    if (isChanged) {
      groupEnd.restart(fullName(group.name()), END);
      say(Kind.GROUP_RESTARTED, group.name(), "the registrar's host or folder has changed");
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
        isChanged ? Kind.RESTARTED : wasActive ? Kind.KEPT : Kind.STARTED,
        "");
    return service;
  }

  /** Forgets a service that did not start, so that nobody takes it for one that is there. */
  private void withdraw(Service service, boolean withGroup)
      throws ActivationException, IOException {
    groupEnd.unregister(service.id());
    Optional<RegisteredGroup> group =
        loader.registered().stream()
            .filter(each -> each.name().equals(service.group()))
            .findFirst();
    if (withGroup && group.isPresent()) {
      groupEnd.end(fullName(service.group()), END);
      groupEnd.unregister(group.get().id());
    }
  }

  private boolean isActive(ActivationGroupID group, ActivationID object)
      throws ActivationException, IOException {
    return patience.ask(() -> admin.activeObjects(group)).contains(object);
  }

  /** A module that is registered as it is described, and does not run as it was before. */
  private record Ready(Service service, ModuleDescription module, Kind kind, String detail) {}

  private Ready ready(ActivationGroupID groupId, String group, ModuleDescription module)
      throws ActivationException, IOException {
    Optional<RegisteredGroup.Module> here = before(group).flatMap(old -> old.module(module.name()));
    ModuleActivation activation = settings.of(module, identity(module, here));
    List<String> changes =
        here.map(old -> ActivationChanges.between(old.activation(), activation)).orElse(List.of());
    boolean wasActive = here.isPresent() && isActive(groupId, here.get().id());
    ActivationID id = loader.module(groupId, group, activation);
    if (here.isPresent() && !changes.isEmpty()) {
      moduleEnd.deactivate(here.get()); // whoever started it meanwhile did so as described before
    }
    String detail =
        moved.containsKey(module.name())
            ? moved.get(module.name()).group()
            : String.join(", ", changes);
    return new Ready(
        new Service(module.path(), group, id),
        module,
        kind(module.name(), wasActive, changes),
        detail);
  }

  private Kind kind(String module, boolean wasActive, List<String> changes) {
    if (moved.containsKey(module)) {
      return Kind.MOVED;
    }
    return !wasActive ? Kind.STARTED : changes.isEmpty() ? Kind.KEPT : Kind.RESTARTED;
  }

  /** The one it had, in whichever group, or before the robot was taken down. */
  private ModuleIdentity identity(ModuleDescription module, Optional<RegisteredGroup.Module> here)
      throws IOException {
    Path folder = settings.folder(module);
    ModuleIdentity identity =
        here.or(() -> Optional.ofNullable(moved.get(module.name())))
            .map(old -> new ModuleIdentity(old.activation().id(), old.activation().created()))
            .or(() -> ModuleIdentity.kept(folder))
            .orElseGet(ModuleIdentity::fresh);
    identity.keep(folder);
    return identity;
  }

  private void say(Kind kind, String group, String detail) {
    step(fullName(group), group, kind, detail);
  }

  private void step(String name, String group, Kind kind, String detail) {
    listener.done(new BringUpStep(name, group, kind, detail));
  }
}
