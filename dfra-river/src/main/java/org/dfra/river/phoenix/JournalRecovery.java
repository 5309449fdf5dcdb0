package org.dfra.river.phoenix;

import java.io.IOException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationInstantiator;
import java.rmi.activation.ActivationSystem;
import java.rmi.server.UID;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Starts a daemon from the journal of its predecessor and the processes that outlived it. */
final class JournalRecovery {

  private static final Logger LOG = LoggerFactory.getLogger(JournalRecovery.class);

  private final PhoenixDaemon daemon;
  private final Journal journal;
  private final Map<ActivationGroupID, ManagedGroup> groups;
  private final Map<UID, ActivatableObject> objects;

  /**
   * @param groups receives the daemon's groups
   * @param objects receives their objects
   */
  JournalRecovery(
      PhoenixDaemon daemon,
      Journal journal,
      Map<ActivationGroupID, ManagedGroup> groups,
      Map<UID, ActivatableObject> objects) {
    this.daemon = daemon;
    this.journal = journal;
    this.groups = groups;
    this.objects = objects;
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
                ManagedGroup group = new ManagedGroup(daemon, id, record.name, record.incarnation);
                groups.put(id, group);
                if (record.process != null && record.process.isAlive()) {
                  ProcessIdentity process = record.process;
                  adoptions.add(() -> adopt(group, process, record));
                }
              });
          registrations.objects.forEach(
              (uid, desc) -> {
                ManagedGroup group = groups.get(desc.getGroupID());
                if (group != null) {
                  objects.put(uid, new ActivatableObject(uid, group, desc));
                }
              });
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
        known = daemon.prepareInstantiator(record.instantiator.get());
      } catch (IOException | ClassNotFoundException e) {
        LOG.warn("The instantiator of group {} cannot be read back: {}", group.name, e.toString());
      }
    }
    group.adopt(process, known, record.leaving, Set.copyOf(record.unregistered()));
    daemon.reportExitTo(group, process, null);
    if (record.leaving) {
      daemon.killIfLingering(process);
    } else if (group.status(0).state() == GroupStatus.State.STARTING) {
      daemon
          .threads()
          .after(daemon.configuration().groupTimeout(), () -> group.killUnlessReported(process));
    }
  }

  private void endStrays() {
    GroupProcess.findRunning(journal.<UUID>read(r -> r.daemon))
        .filter(
            found ->
                groups.values().stream()
                    .filter(group -> group.name.equals(found.group()))
                    .anyMatch(
                        group -> group.process().filter(found::isSameOrDescendantOf).isEmpty()))
        .forEach(
            found -> {
              LOG.warn(
                  "Process {} of group {} is in no journal entry and is ended.",
                  found.process().pid(),
                  found.group());
              found.process().destroy(true);
              found.process().awaitExit(daemon.configuration().groupTimeout());
            });
  }

  /**
   * Gives groups with a former address of phoenix an identity with the present one.
   *
   * <p>A group whose process runs keeps its identity: the process knows no other, and continues.
   */
  void readdress(ActivationSystem system) {
    for (ManagedGroup group : List.copyOf(groups.values())) {
      if (system.equals(group.id.getSystem())) {
        continue;
      }
      if (group.process().isPresent()) {
        LOG.warn(
            "Group {} works on, but knows phoenix at a former address only, and cannot be"
                + " started again after its end; take the robot down and bring it up again.",
            group.name);
        continue;
      }
      try {
        move(group, new ActivationGroupID(system));
      } catch (ActivationException e) {
        LOG.error("Group {} cannot be started at this address: {}", group.name, e.getMessage());
      }
    }
  }

  private void move(ManagedGroup old, ActivationGroupID id) throws ActivationException {
    journal.commit(new Change.GroupMoved(old.id, id));
    ManagedGroup moved = new ManagedGroup(daemon, id, old.name, old.incarnation());
    groups.remove(old.id);
    groups.put(id, moved);
    journal
        .<Map<UID, ActivationDesc>>read(r -> r.objectsOf(id))
        .forEach((uid, desc) -> objects.put(uid, new ActivatableObject(uid, moved, desc)));
    LOG.info("Group {} is to be told of phoenix's new address.", moved.name);
  }
}
