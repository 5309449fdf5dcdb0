package org.dfra.river.phoenix;

import java.io.IOException;
import java.rmi.activation.ActivationInstantiator;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Starts a daemon from the journal of its predecessor and the processes that outlived it. */
final class JournalRecovery {

  private static final Logger LOG = LoggerFactory.getLogger(JournalRecovery.class);

  private final Journal journal;
  private final PhoenixConfiguration configuration;
  private final ProcessWatcher watcher;
  private final ManagedGroup.Factory factory;
  private final GroupTable registered;

  /**
   * @param registered receives the daemon's groups and their objects
   */
  JournalRecovery(
      Journal journal,
      PhoenixConfiguration configuration,
      ProcessWatcher watcher,
      ManagedGroup.Factory factory,
      GroupTable registered) {
    this.journal = journal;
    this.configuration = configuration;
    this.watcher = watcher;
    this.factory = factory;
    this.registered = registered;
  }

  /**
   * Restores the registrations from the journal, adopts the processes that still run, and kills
   * unrecorded processes of registered groups.
   */
  void recover() {
    List<Runnable> adoptions = new ArrayList<>();
    journal.read(
        registrations -> {
          registrations.groups.forEach(
              (id, record) -> {
                ManagedGroup group = factory.create(id, record.name, record.incarnation);
                registered.add(group);
                if (record.process != null && record.process.isAlive()) {
                  ProcessIdentity process = record.process;
                  adoptions.add(() -> adopt(group, process, record));
                }
              });
          registrations.objects.forEach(
              (uid, desc) ->
                  registered
                      .find(desc.getGroupID())
                      .ifPresent(group -> registered.add(new ActivatableObject(uid, group, desc))));
          return null;
        });
    adoptions.forEach(Runnable::run);
    endStrays();
  }

  private void adopt(
      ManagedGroup group, ProcessIdentity process, Registrations.GroupRecord record) {
    @Nullable ActivationInstantiator known = null;
    if (record.instantiator != null) {
      try {
        known = configuration.prepareInstantiator(record.instantiator.get());
      } catch (IOException | ClassNotFoundException e) {
        LOG.warn("The instantiator of group {} cannot be read back: {}", group.name, e.toString());
      }
    }
    group.adopt(process, known, record.leaving, Set.copyOf(record.unregistered()));
    watcher.reportExit(group, process, null);
    if (record.leaving) {
      watcher.killIfLingering(process);
    } else if (group.status(0).state() == GroupStatus.State.STARTING) {
      watcher.limitReport(group, process);
    }
  }

  private void endStrays() {
    GroupProcess.findRunning(journal.<UUID>read(r -> r.daemon))
        .filter(
            found ->
                registered.groups().stream()
                    .filter(group -> group.name.equals(found.group()))
                    .anyMatch(
                        group -> group.process().filter(found::isSameOrDescendantOf).isEmpty()))
        .forEach(
            found -> {
              LOG.warn(
                  "Process {} of group {} is in no journal entry and is ended.",
                  found.process().pid(),
                  found.group());
              found.process().kill();
              found.process().awaitExit(configuration.groupTimeout());
            });
  }
}
