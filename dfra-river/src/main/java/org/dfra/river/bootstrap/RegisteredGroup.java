package org.dfra.river.bootstrap;

import java.io.IOException;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import org.dfra.river.phoenix.Phoenix;
import org.dfra.river.phoenix.PhoenixAdmin;
import org.dfra.river.server.ModuleActivation;
import org.jspecify.annotations.Nullable;

/**
 * A robot's service group as phoenix has it registered, independent of the robot's description.
 *
 * @param id its ID
 * @param name its name, without the robot's
 * @param desc the descriptor with which its processes are started
 * @param modules the modules in it
 * @param registrar the robot's registrar, if it is in this group
 */
record RegisteredGroup(
    ActivationGroupID id,
    String name,
    ActivationGroupDesc desc,
    List<RegisteredModule> modules,
    Optional<RegisteredRegistrar> registrar) {

  /**
   * A module that is registered.
   *
   * @param groupId its group's ID
   * @param group its group's name, without the robot's
   */
  record RegisteredModule(
      ActivationID id, ActivationGroupID groupId, String group, ModuleActivation activation) {

    String name() {
      return activation.module().name();
    }
  }

  /**
   * A registrar that is registered.
   *
   * @param arguments those of its Jini configuration
   */
  record RegisteredRegistrar(ActivationID id, List<String> arguments) {}

  RegisteredGroup {
    modules = List.copyOf(modules);
  }

  /** The module of that name in the group. */
  Optional<RegisteredModule> module(String wanted) {
    return modules.stream().filter(each -> each.name().equals(wanted)).findFirst();
  }

  /** Every group of a robot, in the order of registration. */
  static List<RegisteredGroup> of(PhoenixAdmin admin, String robot)
      throws ActivationException, RemoteException {
    List<RegisteredGroup> found = new ArrayList<>();
    String prefix = robot + ".";
    @SuppressWarnings("unchecked") // as phoenix declares it
    Map<ActivationGroupID, ActivationGroupDesc> groups = admin.getActivationGroups();
    for (Map.Entry<ActivationGroupID, ActivationGroupDesc> each : groups.entrySet()) {
      String name = fullName(each.getValue());
      if (name.startsWith(prefix)) {
        found.add(read(admin, each.getKey(), name.substring(prefix.length()), each.getValue()));
      }
    }
    return found;
  }

  /** {@code robot.group}, as the bootstrap names its groups; empty for groups of other programs. */
  static String fullName(ActivationGroupDesc desc) {
    @Nullable Properties properties = desc.getPropertyOverrides();
    return properties == null ? "" : properties.getProperty(Phoenix.GROUP_NAME, "");
  }

  private static RegisteredGroup read(
      PhoenixAdmin admin, ActivationGroupID id, String name, ActivationGroupDesc desc)
      throws ActivationException, RemoteException {
    List<RegisteredModule> modules = new ArrayList<>();
    Optional<RegisteredRegistrar> registrar = Optional.empty();
    @SuppressWarnings("unchecked") // as phoenix declares it
    Map<ActivationID, ActivationDesc> objects = admin.getActivatableObjects(id);
    for (Map.Entry<ActivationID, ActivationDesc> each : objects.entrySet()) {
      Object data = data(each.getValue());
      if (data instanceof ModuleActivation activation) {
        modules.add(new RegisteredModule(each.getKey(), id, name, activation));
      } else if (each.getValue().getClassName().equals(BootstrapLoader.REGGIE)) {
        registrar =
            Optional.of(
                new RegisteredRegistrar(
                    each.getKey(),
                    data instanceof String[] arguments ? List.of(arguments) : List.of()));
      }
    }
    return new RegisteredGroup(id, name, desc, modules, registrar);
  }

  /**
   * The activation data of an object.
   *
   * @throws ActivationException if the data cannot be read
   */
  static @Nullable Object data(ActivationDesc desc) throws ActivationException {
    try {
      return desc.getData() == null ? null : desc.getData().get();
    } catch (IOException | ClassNotFoundException e) {
      throw new ActivationException(
          "what phoenix keeps of a "
              + desc.getClassName()
              + " cannot be read; it was registered by another version: take the robot down first",
          e);
    }
  }
}
