package org.dfra.river.bootstrap;

import java.io.IOException;
import java.rmi.activation.ActivationException;
import java.time.Duration;
import org.dfra.river.bootstrap.BringUpStep.Kind;
import org.dfra.river.phoenix.GroupStatus;

/**
 * Services that phoenix has forgotten while a process has them, such as those that a {@code down}
 * did not get to end. Their drivers may have any device, so their processes end before a driver is
 * started; see {@link GroupStatus#unregistered}.
 */
final class OrphanedServiceCleanup {

  /** How long the end of one process may take; drivers brake first. */
  private static final Duration END = Duration.ofSeconds(15);

  private final GroupTerminator groupEnd;

  OrphanedServiceCleanup(GroupTerminator groupEnd) {
    this.groupEnd = groupEnd;
  }

  /**
   * Ends the processes that may still have such services, and waits until they are dead. What else
   * is in them is restarted. Processes of other robots end too where nothing else is in them: such
   * a robot may have been this one under another name.
   *
   * @param robot the one of which something is about to be started
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
