package org.dfra.river.phoenix;

import java.rmi.activation.ActivationException;
import java.time.Duration;
import java.util.List;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Activates the objects marked for restart; determines which groups were stable when they ended.
 */
final class GroupRestarter {

  private static final Logger LOG = LoggerFactory.getLogger(GroupRestarter.class);

  private final PhoenixDaemon daemon;
  private final GroupRegistry registered;

  GroupRestarter(PhoenixDaemon daemon, GroupRegistry registered) {
    this.daemon = daemon;
    this.registered = registered;
  }

  /** Activates those objects of a group that are marked for restart, after a delay. */
  void schedule(ManagedGroup group, Duration delay) {
    List<ActivatableObject> marked = marked(registered.objects(group));
    if (marked.isEmpty()) {
      return;
    }
    LOG.info("Objects of group {} are restarted in {} ms.", group.name, delay.toMillis());
    daemon
        .threads()
        .after(
            delay,
            () -> marked.forEach(object -> daemon.threads().execute(() -> restart(object, 1))));
  }

  private static List<ActivatableObject> marked(List<ActivatableObject> objects) {
    return objects.stream().filter(each -> each.desc().getRestartMode()).toList();
  }

  private void restart(ActivatableObject object, int attempt) {
    if (!daemon.isRunning() || !registered.isRegistered(object)) {
      return;
    }
    try {
      object.activate(registered.activationID(object.uid), false);
    } catch (ActivationException e) {
      boolean groupLives = object.group.process().isPresent();
      LOG.warn("Group {}: {}", object.group.name, e.getMessage());
      RestartPolicy policy = daemon.configuration().restartPolicy();
      // If the group itself failed, its own crash history decides on the next start.
      if (groupLives && attempt < policy.crashLimit()) {
        daemon
            .threads()
            .after(
                policy.delay(attempt + 1),
                () -> daemon.threads().execute(() -> restart(object, attempt + 1)));
      }
    }
  }

  /**
   * Whether the modules of a group were stable in an incarnation. All modules marked for restart
   * must have been. If none is marked, all that were activated must have been.
   */
  boolean wasStable(ManagedGroup group, long incarnation) {
    List<ActivatableObject> all = registered.objects(group);
    List<ActivatableObject> marked = marked(all);
    List<ActivatableObject> counted =
        marked.isEmpty()
            ? all.stream().filter(each -> each.wasActive(incarnation)).toList()
            : marked;
    return !counted.isEmpty() && counted.stream().allMatch(each -> each.wasStable(incarnation));
  }
}
