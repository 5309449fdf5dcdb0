package org.dfra.river.phoenix;

import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationSystem;
import java.rmi.activation.UnknownGroupException;
import java.rmi.activation.UnknownObjectException;
import java.rmi.server.UID;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Registers groups and objects with the daemon. It makes every change of the registrations, one at
 * a time: first in the journal, then in the {@link GroupTable}.
 */
final class GroupRegistry {

  private static final Logger LOG = LoggerFactory.getLogger(GroupRegistry.class);

  private final Journal journal;
  private final ExecPolicy execPolicy;
  private final DaemonState state;
  private final ManagedGroup.Factory factory;
  private final GroupTable registered;

  /**
   * @param registered what is registered, in memory
   */
  GroupRegistry(
      Journal journal,
      ExecPolicy execPolicy,
      DaemonState state,
      ManagedGroup.Factory factory,
      GroupTable registered) {
    this.journal = journal;
    this.execPolicy = execPolicy;
    this.state = state;
    this.factory = factory;
    this.registered = registered;
  }

  // Changes

  synchronized ActivationGroupID registerGroup(ActivationGroupID id, ActivationGroupDesc desc)
      throws ActivationException {
    state.requireRunning();
    execPolicy.check(desc);
    String name = journal.<String>read(r -> r.nextNumber + nameHint(desc));
    journal.commit(new JournalRecord.GroupRegistered(id, name, desc));
    registered.add(factory.create(id, name, 0));
    LOG.info("Registered group {}.", name);
    return id;
  }

  private static String nameHint(ActivationGroupDesc desc) {
    String hint =
        desc.getPropertyOverrides() == null
            ? null
            : desc.getPropertyOverrides().getProperty(Phoenix.GROUP_NAME);
    return hint == null ? "-group" : "-" + hint.replaceAll("[^A-Za-z0-9_.]+", ".");
  }

  synchronized ActivationGroupDesc setGroupDesc(ActivationGroupID id, ActivationGroupDesc desc)
      throws ActivationException {
    state.requireRunning();
    ActivationGroupDesc old = journal.groupDesc(id);
    execPolicy.check(desc);
    journal.commit(new JournalRecord.GroupDescribed(id, desc));
    return old;
  }

  synchronized void unregisterGroup(ActivationGroupID id) throws ActivationException {
    state.requireRunning();
    ManagedGroup group = registered.group(id);
    journal.commit(new JournalRecord.GroupUnregistered(id));
    registered.remove(group);
    group.setUnregistered();
    LOG.info("Unregistered group {}.", group.name);
  }

  synchronized UID registerObject(ActivationDesc desc) throws ActivationException {
    state.requireRunning();
    ManagedGroup group = registered.group(desc.getGroupID());
    UID uid = new UID();
    journal.commit(new JournalRecord.ObjectRegistered(uid, desc));
    registered.add(new ActivatableObject(uid, group, desc));
    return uid;
  }

  synchronized ActivationDesc setObjectDesc(UID uid, ActivationDesc desc)
      throws ActivationException {
    state.requireRunning();
    ActivatableObject object = registered.object(uid);
    if (!object.group.id.equals(desc.getGroupID())) {
      throw new ActivationException(
          "the new descriptor is of another group; an object stays in " + object.group.name);
    }
    ActivationDesc old = object.desc();
    journal.commit(new JournalRecord.ObjectDescribed(uid, desc));
    object.setDesc(desc);
    return old;
  }

  /** Unregisters an object. If a process may still have it, its group records that. */
  synchronized void unregisterObject(UID uid) throws ActivationException {
    state.requireRunning();
    ActivatableObject object = registered.object(uid);
    object.retire(); // before reading where it may run: then no new instantiation begins
    long incarnation = object.mayBeActive() ? object.group.incarnation() : 0;
    try {
      journal.commit(new JournalRecord.ObjectUnregistered(uid, incarnation));
    } catch (ActivationException | RuntimeException e) {
      object.reactivate();
      throw e;
    }
    registered.remove(object);
    object.group.addUnregistered(uid, incarnation);
  }

  /** Unregisters an inactive object. Returns false, with nothing changed, if it is active. */
  boolean unregisterInactive(ActivatableObject object) throws ActivationException {
    state.requireRunning();
    if (!object.retireUnlessActive()) {
      return false;
    }
    unregisterObject(object.uid);
    return true;
  }

  /**
   * Records that a group's process reported an object inactive.
   *
   * @throws UnknownObjectException if it is not registered, or not any more
   */
  void inactive(UID uid) throws UnknownObjectException {
    Optional<ActivatableObject> object = registered.find(uid);
    if (object.isPresent()) {
      object.get().inactive();
      return;
    }
    for (ManagedGroup group : registered.groups()) {
      if (group.removeUnregistered(uid)) {
        try {
          journal.commit(new JournalRecord.UnregisteredEnded(group.id, uid));
        } catch (ActivationException e) { // the next daemon kills the surplus process
          LOG.warn("The end of an object of {} is not recorded: {}", group.name, e.getMessage());
        }
      }
    }
    throw new UnknownObjectException("phoenix has no object " + uid + " registered");
  }

  /**
   * Gives groups with a former address of phoenix an identity with the present one.
   *
   * <p>A group whose process runs keeps its identity: the process knows no other, and continues.
   */
  synchronized void updateAddress(ActivationSystem system) {
    for (ManagedGroup group : List.copyOf(registered.groups())) {
      if (system.equals(group.id.getSystem())) {
        continue;
      }
      if (group.process().isPresent()) {
        LOG.warn(
            "Group {} still runs, but knows only phoenix's former address, so phoenix cannot"
                + " restart it; take the robot down and bring it up again.",
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
    journal.commit(new JournalRecord.GroupMoved(old.id, id));
    ManagedGroup moved = factory.create(id, old.name, old.incarnation());
    registered.replace(old, moved);
    journal
        .<Map<UID, ActivationDesc>>read(r -> r.objectsOf(id))
        .forEach((uid, desc) -> registered.add(new ActivatableObject(uid, moved, desc)));
    LOG.info("Group {} will be sent phoenix's new address.", moved.name);
  }

  // Queries

  /**
   * A group's descriptor.
   *
   * @throws UnknownGroupException if it is not registered, or not any more
   */
  ActivationGroupDesc groupDesc(ActivationGroupID id) throws UnknownGroupException {
    return journal.groupDesc(id);
  }

  /** Every group's descriptor. */
  Map<ActivationGroupID, ActivationGroupDesc> groupDescs() {
    return journal.read(
        r -> {
          Map<ActivationGroupID, ActivationGroupDesc> descs = new LinkedHashMap<>();
          r.groups.forEach((id, record) -> descs.put(id, record.desc));
          return descs;
        });
  }

  /** The activation IDs of those of a group's objects that may be active. */
  List<ActivationID> activeObjects(ActivationGroupID id) throws UnknownGroupException {
    return registered.objects(registered.group(id)).stream()
        .filter(ActivatableObject::mayBeActive)
        .map(object -> registered.activationID(object.uid))
        .toList();
  }

  /** The descriptors of a group's objects. */
  Map<ActivationID, ActivationDesc> objectDescs(ActivationGroupID id) throws UnknownGroupException {
    registered.group(id); // or it is unknown
    Map<ActivationID, ActivationDesc> descs = new LinkedHashMap<>();
    journal
        .<Map<UID, ActivationDesc>>read(r -> r.objectsOf(id))
        .forEach((uid, desc) -> descs.put(registered.activationID(uid), desc));
    return descs;
  }

  /** The state of every group, for the administrator. */
  List<GroupStatus> status() {
    List<ActivationGroupID> order = journal.read(r -> List.copyOf(r.groups.keySet()));
    return order.stream()
        .flatMap(id -> registered.find(id).stream())
        .map(group -> group.status(registered.objects(group).size()))
        .toList();
  }
}
