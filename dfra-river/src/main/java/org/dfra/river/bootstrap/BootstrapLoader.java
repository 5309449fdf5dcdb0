package org.dfra.river.bootstrap;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupDesc.CommandEnvironment;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationSystem;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.TreeMap;
import java.util.UUID;
import org.dfra.core.config.GroupDescription;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.RegistrarDescription;
import org.dfra.river.bootstrap.RobotBootstrap.Service;
import org.dfra.river.loading.RobotClasses;
import org.dfra.river.phoenix.Phoenix;
import org.dfra.river.phoenix.PhoenixAdmin;
import org.dfra.river.server.ModuleActivation;
import org.jspecify.annotations.Nullable;

/**
 * Registers what a robot's description names with the activation system: each group, and in it each
 * service with its marshalled activation data. What is registered under the same names already is
 * described anew instead.
 */
final class BootstrapLoader {

  static final String REGGIE = "com.sun.jini.reggie.PersistentRegistrarImpl";

  private final PhoenixAdmin admin;
  private final ActivationSystem system;
  private final String robot;
  private final Optional<RobotClasses> classes;

  /**
   * @param classes what the robot serves to clients that lack its classes
   */
  BootstrapLoader(
      PhoenixAdmin admin, ActivationSystem system, String robot, Optional<RobotClasses> classes) {
    this.admin = admin;
    this.system = system;
    this.robot = robot;
    this.classes = classes;
  }

  /** Registers a service group. */
  ActivationGroupID group(GroupDescription group) throws ActivationException, RemoteException {
    Properties properties = new Properties();
    properties.setProperty(Phoenix.GROUP_NAME, robot + "." + group.name());
    List<String> options = new ArrayList<>(JvmCommand.options());
    classes.ifPresent(each -> options.addAll(each.options(group.registrar().isPresent())));
    options.addAll(group.jvmOptions());
    ActivationGroupDesc desc =
        new ActivationGroupDesc(
            properties, new CommandEnvironment(null, options.toArray(String[]::new)));
    Optional<ActivationGroupID> known = known(properties);
    if (known.isPresent()) {
      system.setActivationGroupDesc(known.get(), desc);
      return known.get();
    }
    return system.registerGroup(desc);
  }

  private Optional<ActivationGroupID> known(Properties wanted) throws RemoteException {
    String name = wanted.getProperty(Phoenix.GROUP_NAME);
    @SuppressWarnings("unchecked") // as phoenix declares it
    Map<ActivationGroupID, ActivationGroupDesc> groups = admin.getActivationGroups();
    return groups.entrySet().stream()
        .filter(
            each ->
                each.getValue().getPropertyOverrides() != null
                    && name.equals(
                        each.getValue().getPropertyOverrides().getProperty(Phoenix.GROUP_NAME)))
        .map(Map.Entry::getKey)
        .findFirst();
  }

  /** Registers the robot's registrar: stock reggie. */
  Service registrar(
      GroupDescription group, RegistrarDescription registrar, MarshalledObject<String[]> data)
      throws ActivationException, IOException {
    ActivationGroupID groupId = group(group);
    ActivationDesc desc = new ActivationDesc(groupId, REGGIE, null, data, registrar.restart());
    @Nullable ActivationID known = null;
    for (Map.Entry<ActivationID, ActivationDesc> each : objects(groupId).entrySet()) {
      if (each.getValue().getClassName().equals(REGGIE)) {
        known = each.getKey();
      }
    }
    return new Service(robot + "/registrar", group.name(), register(known, desc));
  }

  /**
   * Registers a module.
   *
   * @param state folder of what of it outlives its virtual machine
   */
  Service module(
      ActivationGroupID groupId,
      String group,
      ModuleDescription module,
      String host,
      List<String> locators,
      List<String> lookupGroups,
      Path state)
      throws ActivationException, IOException {
    @Nullable ActivationID known = null;
    UUID identity = UUID.randomUUID();
    Instant created = Instant.now();
    for (Map.Entry<ActivationID, ActivationDesc> each : objects(groupId).entrySet()) {
      Optional<ModuleActivation> data = activationData(each.getValue());
      if (data.isPresent() && data.get().module().name().equals(module.name())) {
        known = each.getKey();
        identity = data.get().id();
        created = data.get().created();
      }
    }
    ActivationDesc desc =
        new ActivationDesc(
            groupId,
            module.serverClass(),
            null,
            new MarshalledObject<>(
                new ModuleActivation(
                    module, identity, created, host, lookupGroups, locators, state.toString())),
            module.restart());
    return new Service(module.path(), group, register(known, desc));
  }

  /**
   * A module that is registered.
   *
   * @param groupId its group's ID
   * @param group its group's name, without the robot's
   */
  record Registered(
      ActivationID id, ActivationGroupID groupId, String group, ModuleActivation activation) {}

  /** The robot's modules that are registered now, by name. */
  Map<String, Registered> registered() throws ActivationException, RemoteException {
    Map<String, Registered> modules = new TreeMap<>();
    String prefix = robot + ".";
    @SuppressWarnings("unchecked") // as phoenix declares it
    Map<ActivationGroupID, ActivationGroupDesc> groups = admin.getActivationGroups();
    for (Map.Entry<ActivationGroupID, ActivationGroupDesc> group : groups.entrySet()) {
      @Nullable Properties properties = group.getValue().getPropertyOverrides();
      @Nullable String name =
          properties == null ? null : properties.getProperty(Phoenix.GROUP_NAME);
      if (name != null && name.startsWith(prefix)) {
        for (Map.Entry<ActivationID, ActivationDesc> each : objects(group.getKey()).entrySet()) {
          activationData(each.getValue())
              .ifPresent(
                  data ->
                      modules.put(
                          data.module().name(),
                          new Registered(
                              each.getKey(),
                              group.getKey(),
                              name.substring(prefix.length()),
                              data)));
        }
      }
    }
    return modules;
  }

  private ActivationID register(@Nullable ActivationID known, ActivationDesc desc)
      throws ActivationException, RemoteException {
    if (known == null) {
      return system.registerObject(desc);
    }
    system.setActivationDesc(known, desc);
    return known;
  }

  @SuppressWarnings("unchecked") // as phoenix declares it
  private Map<ActivationID, ActivationDesc> objects(ActivationGroupID group)
      throws ActivationException, RemoteException {
    return admin.getActivatableObjects(group);
  }

  static Optional<ModuleActivation> activationData(ActivationDesc desc) throws ActivationException {
    try {
      return desc.getData() != null && desc.getData().get() instanceof ModuleActivation data
          ? Optional.of(data)
          : Optional.empty();
    } catch (IOException | ClassNotFoundException e) {
      throw new ActivationException(
          "what phoenix keeps of a "
              + desc.getClassName()
              + " cannot be read; it was registered by another version: take the robot down first",
          e);
    }
  }
}
