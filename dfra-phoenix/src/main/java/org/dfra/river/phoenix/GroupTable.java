package org.dfra.river.phoenix;

import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.Activator;
import java.rmi.activation.UnknownGroupException;
import java.rmi.activation.UnknownObjectException;
import java.rmi.server.UID;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;

/**
 * The groups and objects that are registered now, in memory. Thread-safe; no query waits. Only
 * {@link GroupRegistry} and {@link JournalRecovery} change it, after the journal.
 */
final class GroupTable {

  private final Map<ActivationGroupID, ManagedGroup> groups = new ConcurrentHashMap<>();
  private final Map<UID, ActivatableObject> objects = new ConcurrentHashMap<>();
  private volatile @Nullable Activator activator;

  /** Sets the activator that activation IDs carry from now on. */
  void exported(Activator itsActivator) {
    activator = itsActivator;
  }

  // Changes

  /** Adds a group. */
  void add(ManagedGroup group) {
    groups.put(group.id, group);
  }

  /** Adds an object, or replaces the one with its UID. */
  void add(ActivatableObject object) {
    objects.put(object.uid, object);
  }

  /** Removes a group and its objects. */
  void remove(ManagedGroup group) {
    groups.remove(group.id);
    objects.values().removeIf(object -> object.group == group);
  }

  /** Replaces a group; its objects remain until they are replaced too. */
  void replace(ManagedGroup old, ManagedGroup next) {
    groups.remove(old.id);
    groups.put(next.id, next);
  }

  /** Removes an object. */
  void remove(ActivatableObject object) {
    objects.remove(object.uid);
  }

  // Queries

  /** The groups that are registered now. */
  Collection<ManagedGroup> groups() {
    return groups.values();
  }

  /** The group of an ID; empty if it is not registered. */
  Optional<ManagedGroup> find(ActivationGroupID id) {
    return Optional.ofNullable(groups.get(id));
  }

  /** The object of a UID; empty if it is not registered. */
  Optional<ActivatableObject> find(UID uid) {
    return Optional.ofNullable(objects.get(uid));
  }

  /**
   * The group of an ID.
   *
   * @throws UnknownGroupException if it is not registered, or not any more
   */
  ManagedGroup group(ActivationGroupID id) throws UnknownGroupException {
    return find(id)
        .orElseThrow(() -> new UnknownGroupException("phoenix has no such group registered"));
  }

  /**
   * The object of a UID.
   *
   * @throws UnknownObjectException if it is not registered, or not any more
   */
  ActivatableObject object(UID uid) throws UnknownObjectException {
    return find(uid)
        .orElseThrow(
            () -> new UnknownObjectException("phoenix has no object " + uid + " registered"));
  }

  /**
   * The object of an ID that this daemon created.
   *
   * @throws UnknownObjectException if it is of another daemon, or not registered
   */
  ActivatableObject object(ActivationID id) throws UnknownObjectException {
    return object(uid(id));
  }

  /** Whether this object is still the one registered under its UID. */
  boolean isRegistered(ActivatableObject object) {
    return objects.get(object.uid) == object;
  }

  /** The objects of a group. */
  List<ActivatableObject> objects(ManagedGroup group) {
    return objects.values().stream().filter(object -> object.group == group).toList();
  }

  /** The activation ID of a registered object. */
  ActivationID activationID(UID uid) {
    return new JeriActivationID(Objects.requireNonNull(activator, "not exported yet"), uid);
  }

  /**
   * The object's UID within its daemon.
   *
   * @throws UnknownObjectException if the ID is of another activation system
   */
  static UID uid(ActivationID id) throws UnknownObjectException {
    if (!(id instanceof JeriActivationID known)) {
      throw new UnknownObjectException("the ID " + id + " is not one of phoenix's");
    }
    return known.uid();
  }
}
