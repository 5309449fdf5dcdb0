package org.dfra.river.phoenix;

import java.rmi.activation.ActivationException;
import java.time.Duration;
import java.util.List;
import org.dfra.river.phoenix.restart.RestartPolicy;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Activates the objects marked for restart; determines which groups were stable when they ended.
 */
final class GroupRestarter implements ManagedGroup.Restarts {

  private static final Logger LOG = LoggerFactory.getLogger(GroupRestarter.class);

  private final GroupTable registered;
  private final DaemonExecutors threads;
  private final DaemonState state;
  private final RestartPolicy policy;

  GroupRestarter(
      GroupTable registered, DaemonExecutors threads, DaemonState state, RestartPolicy policy) {
    this.registered = registered;
    this.threads = threads;
    this.state = state;
    this.policy = policy;
  }

  @Override
  public void schedule(ManagedGroup group, Duration delay) {
    List<ActivatableObject> marked = marked(registered.objects(group));
    if (marked.isEmpty()) {
      return;
    }
    LOG.info("Objects of group {} are restarted in {} ms.", group.name, delay.toMillis());
    threads.after(delay, () -> marked.forEach(object -> threads.execute(() -> restart(object, 1))));
  }

  private static List<ActivatableObject> marked(List<ActivatableObject> objects) {
    return objects.stream().filter(each -> each.desc().getRestartMode()).toList();
  }

  private void restart(ActivatableObject object, int attempt) {
    if (!state.isRunning() || !registered.isRegistered(object)) {
      return;
    }
    try {
      object.activate(registered.activationID(object.uid), false);
    } catch (ActivationException e) {
      boolean groupLives = object.group.process().isPresent();
      LOG.warn("Group {}: {}", object.group.name, e.getMessage());
      // If the group itself failed, its own crash history decides on the next start.
      if (groupLives && attempt < policy.crashLimit()) {
        threads.after(
            policy.delay(attempt + 1), () -> threads.execute(() -> restart(object, attempt + 1)));
      }
    }
  }

  /**
   * {@inheritDoc} All modules marked for restart must have been. If none is marked, all that were
   * activated must have been.
   */
  @Override
  public boolean wasStable(ManagedGroup group, long incarnation) {
    List<ActivatableObject> all = registered.objects(group);
    List<ActivatableObject> marked = marked(all);
    List<ActivatableObject> counted =
        marked.isEmpty()
            ? all.stream().filter(each -> each.wasActive(incarnation)).toList()
            : marked;
    return !counted.isEmpty() && counted.stream().allMatch(each -> each.wasStable(incarnation));
  }
}
