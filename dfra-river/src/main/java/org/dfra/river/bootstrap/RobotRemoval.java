package org.dfra.river.bootstrap;

import java.io.IOException;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.dfra.core.config.RobotDescription;
import org.dfra.river.bootstrap.Inventory.ServiceGroup;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Takes one robot out of the phoenix of its host, while that and other robots go on. */
public final class RobotRemoval {

  private static final Logger LOG = LoggerFactory.getLogger(RobotRemoval.class);

  private RobotRemoval() {}

  /**
   * Removes the robot's modules, its registrar last, and forgets its groups.
   *
   * @param patience how long each of its processes may take to end before it is killed
   */
  public static void of(PhoenixProcess phoenix, String robot, Duration patience)
      throws IOException, ActivationException, InterruptedException {
    KnownRobots known = new KnownRobots(phoenix.state());
    Optional<RobotDescription> description = known.find(robot);
    List<ServiceGroup> groups =
        new ArrayList<>(
            Inventory.of(phoenix).stream().filter(each -> each.robot().equals(robot)).toList());
    groups.sort((one, other) -> Boolean.compare(one.registrar(), other.registrar()));
    for (ServiceGroup group : groups) {
      if (description.isPresent() && group.status().pid() >= 0) {
        RobotBootstrap bootstrap = new RobotBootstrap(phoenix, description.get());
        for (String module : group.modules()) {
          remove(bootstrap, robot, module);
        }
      }
      phoenix.system().unregisterGroup(group.id());
      end(group, patience);
    }
    known.forget(robot);
  }

  /** In an orderly way, so that its device is closed and it leaves the lookup services. */
  private static void remove(RobotBootstrap bootstrap, String robot, String module)
      throws IOException, ActivationException {
    try {
      bootstrap.remove(module);
    } catch (RemoteException e) {
      LOG.warn("{}/{} does not answer ({}); its process is ended.", robot, module, e.toString());
    }
  }

  private static void end(ServiceGroup group, Duration patience) throws InterruptedException {
    long pid = group.status().pid();
    Optional<ProcessHandle> process = pid < 0 ? Optional.empty() : ProcessHandle.of(pid);
    if (process.isEmpty()) {
      return;
    }
    process.get().destroy();
    try {
      process.get().onExit().get(patience.toMillis(), TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      LOG.warn("Process {} of group {} did not end; it is killed.", pid, group.name());
      process.get().destroyForcibly();
    } catch (ExecutionException e) {
      throw new IllegalStateException("a process's end cannot fail", e);
    }
  }
}
