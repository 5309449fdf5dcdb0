package org.dfra.river.bootstrap;

import java.rmi.RemoteException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.TreeMap;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.river.phoenix.Phoenix;
import org.dfra.river.phoenix.PhoenixAdmin;
import org.jspecify.annotations.Nullable;

/** What is registered with the phoenix of a host: every robot's groups and what is in them. */
public final class Inventory {

  private Inventory() {}

  /**
   * One service group.
   *
   * @param robot name of its robot
   * @param name its name on its robot
   * @param id what the activation system calls it
   * @param status where its virtual machine stands
   * @param modules names of its modules, in alphabetical order
   * @param registrar whether it hosts the robot's registrar
   */
  public record ServiceGroup(
      String robot,
      String name,
      ActivationGroupID id,
      GroupStatus status,
      List<String> modules,
      boolean registrar) {

    public ServiceGroup {
      modules = List.copyOf(modules);
    }
  }

  /**
   * Every group of every robot, by robot and name. Groups that somebody else registered are left
   * out.
   *
   * @throws RemoteException if phoenix does not answer
   * @throws ActivationException if what it keeps cannot be read
   */
  public static List<ServiceGroup> of(PhoenixProcess phoenix)
      throws RemoteException, ActivationException {
    PhoenixAdmin admin = phoenix.admin();
    Map<String, GroupStatus> status = new TreeMap<>();
    admin.groupStatus().forEach(each -> status.put(each.name().replaceFirst("^\\d+-", ""), each));
    Map<String, ServiceGroup> groups = new TreeMap<>();
    @SuppressWarnings("unchecked") // as phoenix declares it
    Map<ActivationGroupID, ActivationGroupDesc> registered = admin.getActivationGroups();
    for (Map.Entry<ActivationGroupID, ActivationGroupDesc> each : registered.entrySet()) {
      @Nullable Properties properties = each.getValue().getPropertyOverrides();
      @Nullable String name =
          properties == null ? null : properties.getProperty(Phoenix.GROUP_NAME);
      @Nullable GroupStatus known = name == null ? null : status.get(name);
      if (name != null && known != null && name.indexOf('.') > 0) {
        groups.put(name, group(admin, each.getKey(), name, known));
      }
    }
    return List.copyOf(groups.values());
  }

  private static ServiceGroup group(
      PhoenixAdmin admin, ActivationGroupID id, String name, GroupStatus status)
      throws RemoteException, ActivationException {
    List<String> modules = new ArrayList<>();
    boolean registrar = false;
    @SuppressWarnings("unchecked") // as phoenix declares it
    Iterable<ActivationDesc> objects = admin.getActivatableObjects(id).values();
    for (ActivationDesc object : objects) {
      Optional<String> module =
          BootstrapLoader.activationData(object).map(data -> data.module().name());
      module.ifPresent(modules::add);
      registrar |= object.getClassName().equals(BootstrapLoader.REGGIE);
    }
    modules.sort(null);
    int dot = name.indexOf('.');
    return new ServiceGroup(
        name.substring(0, dot), name.substring(dot + 1), id, status, modules, registrar);
  }
}
