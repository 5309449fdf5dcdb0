package org.dfra.river.phoenix;

import java.io.Serializable;
import java.rmi.MarshalledObject;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationInstantiator;
import java.rmi.activation.UnknownGroupException;
import java.rmi.server.UID;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.UUID;
import org.jspecify.annotations.Nullable;

/**
 * The daemon's persistent state. Changed only by {@link JournalRecord}s, which the journal writes
 * first. Confined to the journal's lock.
 */
final class Registrations implements Serializable {

  private static final long serialVersionUID = 1L;

  /** Distinguishes this daemon's group processes from those of any other on the machine. */
  final UUID daemon = UUID.randomUUID();

  /** The number in the next group's name. */
  int nextNumber = 1;

  final LinkedHashMap<ActivationGroupID, GroupRecord> groups = new LinkedHashMap<>();
  final LinkedHashMap<UID, ActivationDesc> objects = new LinkedHashMap<>();

  /** A registered group. */
  static final class GroupRecord implements Serializable {
    private static final long serialVersionUID = 1L;

    final String name;
    ActivationGroupDesc desc;
    long incarnation;
    @Nullable ProcessIdentity process;
    @Nullable MarshalledObject<ActivationInstantiator> instantiator;
    boolean leaving;

    /** unregistered objects that the process may have; null in former snapshots */
    private @Nullable Set<UID> unregistered = new LinkedHashSet<>();

    GroupRecord(String name, ActivationGroupDesc desc) {
      this.name = name;
      this.desc = desc;
    }

    /** Unregistered objects that the process may have. */
    Set<UID> unregistered() {
      if (unregistered == null) {
        unregistered = new LinkedHashSet<>();
      }
      return unregistered;
    }
  }

  /** Applies a change. */
  void apply(JournalRecord change) {
    if (change instanceof JournalRecord.GroupRegistered c) {
      groups.put(c.group(), new GroupRecord(c.name(), c.desc()));
      nextNumber++;
    } else if (change instanceof JournalRecord.GroupDescribed c) {
      group(c.group()).desc = c.desc();
    } else if (change instanceof JournalRecord.GroupMoved c) {
      move(c.group(), c.to());
    } else if (change instanceof JournalRecord.GroupUnregistered c) {
      groups.remove(c.group());
      objects.values().removeIf(desc -> desc.getGroupID().equals(c.group()));
    } else if (change instanceof JournalRecord.Launching c) {
      GroupRecord group = group(c.group());
      group.incarnation = c.incarnation();
      group.process = null;
      group.instantiator = null;
      group.leaving = false;
      group.unregistered().clear();
    } else if (change instanceof JournalRecord.Launched c) {
      group(c.group()).process = c.process();
    } else if (change instanceof JournalRecord.Reported c) {
      group(c.group()).instantiator = c.instantiator();
    } else if (change instanceof JournalRecord.Left c) {
      group(c.group()).leaving = true;
    } else if (change instanceof JournalRecord.ObjectRegistered c) {
      objects.put(c.object(), c.desc());
    } else if (change instanceof JournalRecord.ObjectDescribed c) {
      objects.put(c.object(), c.desc());
    } else if (change instanceof JournalRecord.ObjectUnregistered c) {
      unregister(c);
    } else if (change instanceof JournalRecord.UnregisteredEnded c) {
      group(c.group()).unregistered().remove(c.object());
    }
  }

  private void unregister(JournalRecord.ObjectUnregistered change) {
    @Nullable ActivationDesc desc = objects.remove(change.object());
    @Nullable GroupRecord group = desc == null ? null : groups.get(desc.getGroupID());
    if (group != null && change.incarnation() != 0 && change.incarnation() == group.incarnation) {
      group.unregistered().add(change.object());
    }
  }

  private void move(ActivationGroupID from, ActivationGroupID to) {
    Map<ActivationGroupID, GroupRecord> before = new LinkedHashMap<>(groups);
    groups.clear(); // keeps the order
    before.forEach((id, record) -> groups.put(id.equals(from) ? to : id, record));
    objects.replaceAll((uid, desc) -> desc.getGroupID().equals(from) ? inGroup(desc, to) : desc);
  }

  private static ActivationDesc inGroup(ActivationDesc desc, ActivationGroupID group) {
    return new ActivationDesc(
        group, desc.getClassName(), desc.getLocation(), desc.getData(), desc.getRestartMode());
  }

  /**
   * Refuses a change of a group that is not registered. Once written, it would make the journal
   * unreadable.
   *
   * @throws UnknownGroupException if the group was unregistered meanwhile
   */
  void check(JournalRecord change) throws UnknownGroupException {
    @Nullable ActivationGroupID group = groupOf(change);
    if (group != null && !groups.containsKey(group)) {
      throw new UnknownGroupException("the group is not registered with phoenix any more");
    }
  }

  private static @Nullable ActivationGroupID groupOf(JournalRecord change) {
    if (change instanceof JournalRecord.GroupDescribed c) {
      return c.group();
    } else if (change instanceof JournalRecord.GroupMoved c) {
      return c.group();
    } else if (change instanceof JournalRecord.GroupUnregistered c) {
      return c.group();
    } else if (change instanceof JournalRecord.Launching c) {
      return c.group();
    } else if (change instanceof JournalRecord.Launched c) {
      return c.group();
    } else if (change instanceof JournalRecord.Reported c) {
      return c.group();
    } else if (change instanceof JournalRecord.Left c) {
      return c.group();
    } else if (change instanceof JournalRecord.UnregisteredEnded c) {
      return c.group();
    } else if (change instanceof JournalRecord.ObjectRegistered c) {
      return c.desc().getGroupID();
    }
    return null;
  }

  /** The record of a group; a change of an unknown group means a damaged journal. */
  GroupRecord group(ActivationGroupID id) {
    @Nullable GroupRecord group = groups.get(id);
    if (group == null) {
      throw new IllegalStateException("a change of a group that is not registered");
    }
    return group;
  }

  /** The objects of a group. */
  Map<UID, ActivationDesc> objectsOf(ActivationGroupID group) {
    Map<UID, ActivationDesc> found = new LinkedHashMap<>();
    objects.forEach(
        (uid, desc) -> {
          if (desc.getGroupID().equals(group)) {
            found.put(uid, desc);
          }
        });
    return found;
  }
}
