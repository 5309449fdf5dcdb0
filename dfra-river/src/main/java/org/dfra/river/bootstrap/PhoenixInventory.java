package org.dfra.river.bootstrap;

import java.io.IOException;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.river.phoenix.PhoenixAdmin;
import org.dfra.river.server.ModuleActivation;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The registrations with the phoenix of a host: every robot's groups and their contents. */
public final class PhoenixInventory {

  private static final Logger LOG = LoggerFactory.getLogger(PhoenixInventory.class);

  private PhoenixInventory() {}

  /**
   * One service group.
   *
   * @param robot name of its robot
   * @param name its name on its robot
   * @param id its ID in the activation system
   * @param status state of its virtual machine
   * @param modules names of its modules, in alphabetical order
   * @param registrar whether it hosts the robot's registrar, and whether this runs
   * @param runningModules names of those of its modules that run
   */
  public record ServiceGroup(
      String robot,
      String name,
      ActivationGroupID id,
      GroupStatus status,
      List<String> modules,
      RegistrarState registrar,
      Set<String> runningModules) {

    /** The state of the robot's registrar in a group. */
    public enum RegistrarState {
      /** The group hosts no registrar. */
      NONE,
      NOT_RUNNING,
      RUNNING
    }

    public ServiceGroup {
      modules = List.copyOf(modules);
      runningModules = Set.copyOf(runningModules);
    }
  }

  /**
   * A service of a robot as it is registered, independent of any XML.
   *
   * @param group its group, as {@code robot.group}
   * @param name the module's name; null if phoenix's data of it cannot be read here, or it is no
   *     module
   * @param serverClass the class of its server
   * @param id its ID in the activation system
   */
  public record RegisteredService(
      String group, @Nullable String name, String serverClass, ActivationID id) {

    /** The name of its robot. */
    public String robot() {
      return group.substring(0, group.indexOf('.'));
    }
  }

  /**
   * Every service of every robot. Each call to phoenix is made once, without retries, for callers
   * that cannot wait.
   *
   * @throws IOException if phoenix does not answer
   * @throws ActivationException if a group was unregistered meanwhile
   */
  public static List<RegisteredService> services(PhoenixProcess phoenix)
      throws IOException, ActivationException {
    PhoenixAdmin admin = phoenix.admin();
    List<RegisteredService> services = new ArrayList<>();
    @SuppressWarnings("unchecked") // as phoenix declares it
    Map<ActivationGroupID, ActivationGroupDesc> groups = admin.getActivationGroups();
    for (Map.Entry<ActivationGroupID, ActivationGroupDesc> group : groups.entrySet()) {
      String name = RegisteredGroup.fullName(group.getValue());
      if (name.indexOf('.') <= 0) {
        continue; // registered by another program
      }
      @SuppressWarnings("unchecked") // as phoenix declares it
      Map<ActivationID, ActivationDesc> objects = admin.getActivatableObjects(group.getKey());
      for (Map.Entry<ActivationID, ActivationDesc> each : objects.entrySet()) {
        services.add(
            new RegisteredService(
                name, moduleName(each.getValue()), each.getValue().getClassName(), each.getKey()));
      }
    }
    return services;
  }

  private static @Nullable String moduleName(ActivationDesc desc) {
    try {
      return RegisteredGroup.data(desc) instanceof ModuleActivation data
          ? data.module().name()
          : null;
    } catch (ActivationException e) {
      LOG.debug("It has no name here.", e);
      return null;
    }
  }

  /**
   * Every group of every robot, by robot and name. Groups of other programs are left out.
   *
   * @param time time limit for retries if phoenix does not answer
   * @throws IOException if phoenix does not answer
   * @throws ActivationException if its data cannot be read
   */
  public static List<ServiceGroup> groups(PhoenixProcess phoenix, Duration time)
      throws IOException, ActivationException {
    return groups(phoenix.admin(), RetryDeadline.of(time));
  }

  static List<ServiceGroup> groups(PhoenixAdmin admin, RetryDeadline patience)
      throws IOException, ActivationException {
    return patience.call(() -> read(admin));
  }

  private static List<ServiceGroup> read(PhoenixAdmin admin)
      throws RemoteException, ActivationException {
    Map<String, GroupStatus> status = new TreeMap<>();
    admin.groupStatus().forEach(each -> status.put(GroupTerminator.plain(each.name()), each));
    Map<String, ServiceGroup> groups = new TreeMap<>();
    @SuppressWarnings("unchecked") // as phoenix declares it
    Map<ActivationGroupID, ActivationGroupDesc> registered = admin.getActivationGroups();
    for (Map.Entry<ActivationGroupID, ActivationGroupDesc> each : registered.entrySet()) {
      String name = RegisteredGroup.fullName(each.getValue());
      @Nullable GroupStatus known = status.get(name);
      if (known != null && name.indexOf('.') > 0) {
        groups.put(name, group(admin, each.getKey(), name, known));
      }
    }
    return List.copyOf(groups.values());
  }

  private static ServiceGroup group(
      PhoenixAdmin admin, ActivationGroupID id, String name, GroupStatus status)
      throws RemoteException, ActivationException {
    List<String> modules = new ArrayList<>();
    Set<String> running = new HashSet<>();
    ServiceGroup.RegistrarState registrar = ServiceGroup.RegistrarState.NONE;
    Set<ActivationID> active = Set.copyOf(admin.activeObjects(id));
    @SuppressWarnings("unchecked") // as phoenix declares it
    Map<ActivationID, ActivationDesc> objects = admin.getActivatableObjects(id);
    for (Map.Entry<ActivationID, ActivationDesc> object : objects.entrySet()) {
      boolean runs = active.contains(object.getKey());
      if (RegisteredGroup.data(object.getValue()) instanceof ModuleActivation data) {
        modules.add(data.module().name());
        if (runs) {
          running.add(data.module().name());
        }
      } else if (object.getValue().getClassName().equals(BootstrapLoader.REGGIE)) {
        registrar =
            runs ? ServiceGroup.RegistrarState.RUNNING : ServiceGroup.RegistrarState.NOT_RUNNING;
      }
    }
    modules.sort(null);
    int dot = name.indexOf('.');
    return new ServiceGroup(
        name.substring(0, dot), name.substring(dot + 1), id, status, modules, registrar, running);
  }
}
