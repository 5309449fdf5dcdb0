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
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Properties;
import java.util.stream.Collectors;
import org.dfra.core.config.RegistrarDescription;
import org.dfra.core.config.RobotDescription.AdministrationDescription;
import org.dfra.core.config.RobotDescription.GroupDescription;
import org.dfra.river.access.AddressRange;
import org.dfra.river.access.AdministrationPolicy;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.loading.RobotCodebase;
import org.dfra.river.phoenix.Phoenix;
import org.dfra.river.phoenix.PhoenixAdmin;
import org.dfra.river.security.SecureProcess;
import org.dfra.river.server.ModuleActivation;
import org.jspecify.annotations.Nullable;

/**
 * Registers the contents of a robot's description with the activation system: each group, and in it
 * each service with its marshalled activation data. A service that is already registered under the
 * same name gets a new description instead. So every call here is idempotent and is retried if no
 * answer arrives.
 */
final class BootstrapLoader {

  static final String REGGIE = "com.sun.jini.reggie.PersistentRegistrarImpl";

  private final PhoenixAdmin admin;
  private final ActivationSystem system;
  private final Path state;
  private final String robot;
  private final AdministrationDescription administration;
  private final Optional<RobotCodebase> classes;
  private final RetryDeadline patience;
  private @Nullable String administrators; // resolved when first needed, and once

  /**
   * @param administration the addresses that may administer the robot
   * @param classes what the robot serves to clients that lack its classes
   */
  BootstrapLoader(
      PhoenixClient phoenix,
      String robot,
      AdministrationDescription administration,
      Optional<RobotCodebase> classes,
      RetryDeadline patience) {
    this.admin = phoenix.admin();
    this.system = phoenix.system();
    this.state = phoenix.state();
    this.robot = robot;
    this.administration = administration;
    this.classes = classes;
    this.patience = patience;
  }

  /** The groups of the robot that phoenix has registered now. */
  List<RegisteredGroup> registeredGroups() throws ActivationException, IOException {
    return patience.call(() -> RegisteredGroup.of(admin, robot));
  }

  /** The robot's modules that are registered now. */
  List<RegisteredGroup.RegisteredModule> modules() throws ActivationException, IOException {
    return registeredGroups().stream().flatMap(group -> group.modules().stream()).toList();
  }

  private Optional<RegisteredGroup> registered(String group)
      throws ActivationException, RemoteException {
    return RegisteredGroup.of(admin, robot).stream()
        .filter(each -> each.name().equals(group))
        .findFirst();
  }

  /**
   * The addresses of the robot's administrators, with commas between; empty for its own computer.
   *
   * @throws org.dfra.core.config.ConfigurationException if one of their hosts is not known
   */
  String administrators() {
    @Nullable String known = administrators;
    if (known == null) {
      known =
          AddressRangeResolver.resolve(administration).stream()
              .map(AddressRange::toString)
              .collect(Collectors.joining(","));
      administrators = known;
    }
    return known;
  }

  /** The descriptor with which a group's processes are started. */
  ActivationGroupDesc desc(GroupDescription group) {
    Properties properties = new Properties();
    properties.setProperty(Phoenix.GROUP_NAME, robot + "." + group.name());
    if (!administrators().isEmpty()) {
      properties.setProperty(AdministrationPolicy.PROPERTY, administrators());
    }
    Path security = SecureProcess.folder(state);
    if (IdentityFolder.isJoined(security)) {
      properties.setProperty(SecureProcess.PROPERTY, security.toAbsolutePath().toString());
    }
    List<String> options = launchOptions(group);
    options.addAll(group.jvmOptions());
    return new ActivationGroupDesc(
        properties, new CommandEnvironment(null, options.toArray(String[]::new)));
  }

  /** The options that the robot's XML does not name. */
  private List<String> launchOptions(GroupDescription group) {
    List<String> options = new ArrayList<>(JvmCommand.lastingOptions());
    options.addAll(HeapOptions.of(group.jvmOptions()));
    classes.ifPresent(each -> options.addAll(each.options(group.registrar().isPresent())));
    return options;
  }

  /** Registers a service group. */
  ActivationGroupID registerGroup(GroupDescription group) throws ActivationException, IOException {
    ActivationGroupDesc desc = desc(group);
    PermittedLaunchOptions.permit(state, launchOptions(group));
    return patience.call(
        () -> {
          Optional<RegisteredGroup> known = registered(group.name());
          if (known.isEmpty()) {
            return system.registerGroup(desc);
          }
          if (!known.get().desc().equals(desc)) {
            system.setActivationGroupDesc(known.get().id(), desc);
          }
          return known.get().id();
        });
  }

  /** Registers the robot's registrar: stock reggie. */
  ActivationID registerRegistrar(
      GroupDescription group, RegistrarDescription registrar, MarshalledObject<String[]> data)
      throws ActivationException, IOException {
    ActivationGroupID groupId = registerGroup(group);
    ActivationDesc desc = new ActivationDesc(groupId, REGGIE, null, data, registrar.restart());
    return patience.call(
        () ->
            register(
                registered(group.name())
                    .flatMap(RegisteredGroup::registrar)
                    .map(RegisteredGroup.RegisteredRegistrar::id),
                desc));
  }

  /**
   * Registers a module in a group.
   *
   * @param group the group's name
   */
  ActivationID registerModule(ActivationGroupID groupId, String group, ModuleActivation activation)
      throws ActivationException, IOException {
    ActivationDesc desc =
        new ActivationDesc(
            groupId,
            activation.module().serverClass(),
            null,
            new MarshalledObject<>(activation),
            activation.module().restart());
    return patience.call(
        () ->
            register(
                registered(group)
                    .flatMap(each -> each.module(activation.module().name()))
                    .map(RegisteredGroup.RegisteredModule::id),
                desc));
  }

  private ActivationID register(Optional<ActivationID> known, ActivationDesc desc)
      throws ActivationException, RemoteException {
    if (known.isEmpty()) {
      return system.registerObject(desc);
    }
    system.setActivationDesc(known.get(), desc);
    return known.get();
  }
}
