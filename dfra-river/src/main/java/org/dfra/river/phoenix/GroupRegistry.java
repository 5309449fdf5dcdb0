package org.dfra.river.phoenix;

import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationSystem;
import java.rmi.activation.Activator;
import java.rmi.activation.UnknownGroupException;
import java.rmi.activation.UnknownObjectException;
import java.rmi.server.UID;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The groups and objects that are registered with the daemon. It makes every change of the
 * registrations, one at a time: first in the journal, then in memory.
 */
final class GroupRegistry {

  private static final Logger LOG = LoggerFactory.getLogger(GroupRegistry.class);

  private final PhoenixDaemon daemon;
  private final Journal journal;
  private final Map<ActivationGroupID, ManagedGroup> groups = new ConcurrentHashMap<>();
  private final Map<UID, ActivatableObject> objects = new ConcurrentHashMap<>();
  private volatile @Nullable Activator activator;

  GroupRegistry(PhoenixDaemon daemon, Journal journal) {
    this.daemon = daemon;
    this.journal = journal;
  }

  /** Restores the registrations from the journal. */
  void recover() {
    recovery().recover();
  }

  /** Gives groups with a former address of phoenix an identity with the present one. */
  synchronized void readdress(ActivationSystem system) {
    recovery().readdress(system);
  }

  private JournalRecovery recovery() {
    return new JournalRecovery(daemon, journal, groups, objects);
  }

  /** Sets the activator that activation IDs carry from now on. */
  void exported(Activator itsActivator) {
    activator = itsActivator;
  }

  // Changes

  synchronized ActivationGroupID registerGroup(ActivationGroupID id, ActivationGroupDesc desc)
      throws ActivationException {
    daemon.requireRunning();
    daemon.configuration().execPolicy().check(desc);
    String name = journal.<String>read(r -> r.nextNumber + nameHint(desc));
    journal.commit(new Change.GroupRegistered(id, name, desc));
    groups.put(id, new ManagedGroup(daemon, id, name, 0));
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
    daemon.requireRunning();
    ActivationGroupDesc old = groupDesc(id);
    daemon.configuration().execPolicy().check(desc);
    journal.commit(new Change.GroupDescribed(id, desc));
    return old;
  }

  synchronized void unregisterGroup(ActivationGroupID id) throws ActivationException {
    daemon.requireRunning();
    ManagedGroup group = group(id);
    journal.commit(new Change.GroupUnregistered(id));
    groups.remove(id);
    objects.values().removeIf(object -> object.group == group);
    group.setUnregistered();
    LOG.info("Unregistered group {}.", group.name);
  }

  synchronized UID registerObject(ActivationDesc desc) throws ActivationException {
    daemon.requireRunning();
    ManagedGroup group = group(desc.getGroupID());
    UID uid = new UID();
    journal.commit(new Change.ObjectRegistered(uid, desc));
    objects.put(uid, new ActivatableObject(uid, group, desc));
    return uid;
  }

  synchronized ActivationDesc setObjectDesc(UID uid, ActivationDesc desc)
      throws ActivationException {
    daemon.requireRunning();
    ActivatableObject object = object(uid);
    if (!object.group.id.equals(desc.getGroupID())) {
      throw new ActivationException(
          "the new descriptor is of another group; an object stays in " + object.group.name);
    }
    ActivationDesc old = object.desc();
    journal.commit(new Change.ObjectDescribed(uid, desc));
    object.setDesc(desc);
    return old;
  }

  /** Unregisters an object. If a process may still have it, its group records that. */
  synchronized void unregisterObject(UID uid) throws ActivationException {
    daemon.requireRunning();
    ActivatableObject object = object(uid);
    object.retire(); // before reading where it may run: then no new instantiation begins
    long incarnation = object.mayBeActive() ? object.group.incarnation() : 0;
    try {
      journal.commit(new Change.ObjectUnregistered(uid, incarnation));
    } catch (ActivationException | RuntimeException e) {
      object.unretire();
      throw e;
    }
    objects.remove(uid);
    object.group.addUnregistered(uid, incarnation);
  }

  /** Unregisters an inactive object. Returns false, with nothing changed, if it is active. */
  boolean unregisterInactive(ActivatableObject object) throws ActivationException {
    daemon.requireRunning();
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
    @Nullable ActivatableObject object = objects.get(uid);
    if (object != null) {
      object.inactive();
      return;
    }
    for (ManagedGroup group : groups.values()) {
      if (group.removeUnregistered(uid)) {
        try {
          journal.commit(new Change.UnregisteredEnded(group.id, uid));
        } catch (ActivationException e) { // the next daemon kills the surplus process
          LOG.warn("The end of an object of {} is not recorded: {}", group.name, e.getMessage());
        }
      }
    }
    throw new UnknownObjectException("phoenix has no such object registered");
  }

  // Queries

  /** The groups that are registered now. */
  Collection<ManagedGroup> groups() {
    return groups.values();
  }

  ManagedGroup group(ActivationGroupID id) throws UnknownGroupException {
    ManagedGroup group = groups.get(id);
    if (group == null) {
      throw new UnknownGroupException("phoenix has no such group registered");
    }
    return group;
  }

  ActivationGroupDesc groupDesc(ActivationGroupID id) throws UnknownGroupException {
    group(id);
    return journal.read(r -> r.group(id).desc);
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

  ActivatableObject object(UID uid) throws UnknownObjectException {
    ActivatableObject object = objects.get(uid);
    if (object == null) {
      throw new UnknownObjectException("phoenix has no such object registered");
    }
    return object;
  }

  /** Whether this object is still the one registered under its UID. */
  boolean isRegistered(ActivatableObject object) {
    return objects.get(object.uid) == object;
  }

  /** The objects of a group. */
  List<ActivatableObject> objects(ManagedGroup group) {
    return objects.values().stream().filter(object -> object.group == group).toList();
  }

  /** The activation IDs of those of a group's objects that may be active. */
  List<ActivationID> activeObjects(ActivationGroupID id) throws UnknownGroupException {
    return objects(group(id)).stream()
        .filter(ActivatableObject::mayBeActive)
        .map(object -> activationID(object.uid))
        .toList();
  }

  /** The descriptors of a group's objects. */
  Map<ActivationID, ActivationDesc> objectDescs(ActivationGroupID id) throws UnknownGroupException {
    group(id);
    Map<ActivationID, ActivationDesc> descs = new LinkedHashMap<>();
    journal
        .<Map<UID, ActivationDesc>>read(r -> r.objectsOf(id))
        .forEach((uid, desc) -> descs.put(activationID(uid), desc));
    return descs;
  }

  /** The activation ID of a registered object. */
  ActivationID activationID(UID uid) {
    return new JeriActivationID(Objects.requireNonNull(activator, "not exported yet"), uid);
  }

  /** The state of every group, for the administrator. */
  List<GroupStatus> status() {
    List<ActivationGroupID> order = journal.read(r -> List.copyOf(r.groups.keySet()));
    return order.stream()
        .map(groups::get)
        .filter(Objects::nonNull)
        .map(group -> group.status(objects(group).size()))
        .toList();
  }
}
