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
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.dfra.river.phoenix.PhoenixAdmin;

/**
 * Removes robots from the phoenix of their host: their processes end and all their registrations
 * are removed, while phoenix and other robots continue.
 *
 * <p>The processes are ended by signal: each closes its modules in order. So no remote answer is
 * needed, and a process that hangs is killed.
 */
public final class RobotRemoval {

  private final PhoenixAdmin admin;
  private final GroupTerminator end;
  private final RetryDeadline patience;
  private final Duration time;

  private record EmptiedGroup(ActivationGroupID id, String name, boolean registrar) {}

  /**
   * @param patience limits the retries of calls to phoenix
   * @param time time limit for the end of one process
   */
  RobotRemoval(PhoenixClient phoenix, RetryDeadline patience, Duration time) {
    this.admin = phoenix.admin();
    this.patience = patience;
    this.end = new GroupTerminator(phoenix, patience);
    this.time = time;
  }

  /**
   * Removes one robot.
   *
   * @param time time limit for the end of each process, after which it is killed, and for retries
   *     if phoenix does not answer
   */
  public static void removeRobot(PhoenixProcess phoenix, String robot, Duration time)
      throws IOException, ActivationException {
    of(phoenix, time).remove(robot);
    new RobotDescriptionStore(phoenix.state()).delete(robot);
  }

  /** Removes all robots, as {@link #removeRobot}. */
  public static void removeAllRobots(PhoenixProcess phoenix, Duration time)
      throws IOException, ActivationException {
    of(phoenix, time).remove(name -> true);
    new RobotDescriptionStore(phoenix.state()).deleteAll();
  }

  /** Names of the robots that have a group registered with a phoenix, in alphabetical order. */
  public static List<String> robots(PhoenixProcess phoenix, Duration time)
      throws IOException, ActivationException {
    return of(phoenix, time).names().values().stream()
        .map(name -> name.substring(0, name.indexOf('.')))
        .distinct()
        .sorted()
        .toList();
  }

  /** The robots' groups, and their names as {@code robot.group}. */
  private Map<ActivationGroupID, String> names() throws IOException, ActivationException {
    @SuppressWarnings("unchecked") // as phoenix declares it
    Map<ActivationGroupID, ActivationGroupDesc> all = patience.call(admin::getActivationGroups);
    Map<ActivationGroupID, String> names = new LinkedHashMap<>();
    all.forEach(
        (id, desc) -> {
          String name = RegisteredGroup.fullName(desc);
          if (name.indexOf('.') > 0) {
            names.put(id, name);
          }
        });
    return names;
  }

  private static RobotRemoval of(PhoenixProcess phoenix, Duration time) throws RemoteException {
    return new RobotRemoval(PhoenixClient.to(phoenix), RetryDeadline.of(time), time);
  }

  /** Unregisters a robot's services and groups and ends their processes. */
  void remove(String robot) throws IOException, ActivationException {
    remove(name -> name.startsWith(robot + "."));
  }

  private void remove(Predicate<String> wanted) throws IOException, ActivationException {
    List<EmptiedGroup> groups = new ArrayList<>();
    for (Map.Entry<ActivationGroupID, String> each : names().entrySet()) {
      if (wanted.test(each.getValue())) {
        groups.add(empty(each.getKey(), each.getValue()));
      }
    }
    // The registrars end last, so that modules can unregister from them.
    end(groups.stream().filter(each -> !each.registrar()).toList());
    end(groups.stream().filter(EmptiedGroup::registrar).toList());
  }

  /** Unregisters the services in a group, so that phoenix starts none of them again. */
  private EmptiedGroup empty(ActivationGroupID group, String name)
      throws IOException, ActivationException {
    boolean isRegistrars = false;
    @SuppressWarnings("unchecked") // as phoenix declares it
    Map<ActivationID, ActivationDesc> objects =
        patience.call(() -> admin.getActivatableObjects(group));
    for (Map.Entry<ActivationID, ActivationDesc> each : objects.entrySet()) {
      isRegistrars |= each.getValue().getClassName().equals(BootstrapLoader.REGGIE);
      end.unregister(each.getKey());
    }
    return new EmptiedGroup(group, name, isRegistrars);
  }

  private void end(List<EmptiedGroup> groups) throws IOException, ActivationException {
    for (EmptiedGroup each : groups) { // all at once, then waits for each
      end.requestStop(each.name());
    }
    for (EmptiedGroup each : groups) {
      end.terminate(each.name(), time);
      end.unregister(each.id());
    }
  }
}
