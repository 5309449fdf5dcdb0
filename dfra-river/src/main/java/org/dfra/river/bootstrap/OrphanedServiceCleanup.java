package org.dfra.river.bootstrap;

import java.io.IOException;
import java.rmi.activation.ActivationException;
import java.time.Duration;
import org.dfra.river.bootstrap.BringUpStep.Kind;
import org.dfra.river.phoenix.GroupStatus;

/**
 * Ends services that are no longer registered with phoenix but still run in a process, for example
 * after an incomplete {@code down}. Their drivers may have any device open, so their processes end
 * before a driver is started; see {@link GroupStatus#unregistered}.
 */
final class OrphanedServiceCleanup {

  /** The time limit for the end of one process; drivers brake first. */
  private static final Duration END = Duration.ofSeconds(15);

  private final GroupTerminator groupEnd;

  OrphanedServiceCleanup(GroupTerminator groupEnd) {
    this.groupEnd = groupEnd;
  }

  /**
   * Ends the processes that may still have such services, and waits until they have exited. Other
   * services in them are restarted. Processes of other robots also end if they contain nothing
   * else: such a robot may be this one under a former name.
   *
   * @param robot the robot whose services are about to be started
   * @param listener is called for each process that was ended
   */
  void terminateProcesses(String robot, BringUpStep.Listener listener)
      throws ActivationException, IOException {
    for (GroupStatus each : groupEnd.statuses()) {
      String name = GroupTerminator.plain(each.name());
      boolean isOwn = name.startsWith(robot + ".");
      if (each.unregistered() == 0 || !(isOwn || each.objects() == 0)) {
        continue;
      }
      if (each.objects() == 0) {
        groupEnd.terminate(name, END);
      } else {
        groupEnd.restart(name, END);
      }
      String group = name.substring(name.indexOf('.') + 1);
      listener.onStep(
          new BringUpStep(name, group, Kind.PROCESS_ENDED, Integer.toString(each.unregistered())));
    }
  }
}
