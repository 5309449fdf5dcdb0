package org.dfra.river.phoenix;

import java.rmi.activation.ActivationException;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What the end of a group's process leads to: nothing where it was to end, else a start after a
 * delay, or none for a while where it crashed too often. It also explains to waiting threads why
 * there is no process for them. Confined to the group's lock.
 */
final class GroupSupervisor {

  private static final Logger LOG = LoggerFactory.getLogger(GroupSupervisor.class);

  private final PhoenixDaemon daemon;
  private final ManagedGroup group;
  private final CrashHistory crashes;
  private boolean forgotten;
  private String lastFailure = "";

  GroupSupervisor(PhoenixDaemon daemon, ManagedGroup group) {
    this.daemon = daemon;
    this.group = group;
    this.crashes = new CrashHistory(daemon.configuration().restartPolicy(), daemon.time()::nanos);
  }

  /** The group was unregistered: no end of its process is a crash from now on. */
  void ignoreExits() {
    forgotten = true;
  }

  /**
   * The group's process has announced its end: it is recorded, and forced later if necessary. Where
   * it cannot be recorded, nothing is lost: a daemon that is started later takes the process for an
   * active one, asks it for an object, and gets the same announcement.
   *
   * @param process null where it is not launched yet
   */
  void leaves(@Nullable ProcessIdentity process) {
    LOG.info("Group {} has nothing left to do; its process ends.", group.name);
    if (process != null) {
      daemon.killIfLingering(process);
    }
    try {
      daemon.journal().commit(new Change.Left(group.id));
    } catch (ActivationException e) {
      LOG.warn("That group {} ends is not recorded: {}", group.name, e.getMessage());
    }
  }

  /**
   * The group's process has ended, or was never launched. That is a crash, but where it was
   * announced, the group is forgotten or the daemon itself ends.
   *
   * @param wasAnnounced whether the process had said that it would
   * @param wasStable whether its modules had worked in it
   */
  void ended(ProcessExit end, boolean wasAnnounced, boolean wasStable) {
    String how = end.description();
    lastFailure = how + "; see " + daemon.output(group.name) + " and the .vm.log beside it";
    if (wasAnnounced || forgotten || !daemon.isRunning()) {
      LOG.info("Group {} {}.", group.name, how);
      return;
    }
    if (end.isRequested()) {
      crashes.recordRequestedExit(wasStable);
    } else {
      crashes.recordCrash(how, wasStable);
    }
    LOG.warn("Group {} {} ({} crashes lately).", group.name, how, crashes.recentCount());
    Optional<Duration> delay = crashes.restartDelay();
    if (delay.isPresent()) {
      daemon.groupRestarter().schedule(group, delay.get());
    } else {
      LOG.error(
          "Group {} crashed {} times within {} s: it is left alone until {} and then started by"
              + " the next call. See {}.",
          group.name,
          crashes.recentCount(),
          daemon.configuration().restartPolicy().window().toSeconds(),
          heldOffUntil().map(Instant::toString).orElse("now"),
          daemon.output(group.name));
    }
  }

  /** That the group's process was not ready in time, for whoever waited for it. */
  ActivationException timeoutFailure() {
    return new ActivationException(
        "group "
            + group.name
            + " was not ready within "
            + daemon.configuration().groupTimeout().toMillis()
            + " ms; see "
            + daemon.output(group.name));
  }

  /** How the group's process ended the last time, for whoever waited for it. */
  ActivationException failure() {
    return new ActivationException("group " + group.name + " " + lastFailure);
  }

  /**
   * Refuses a start while the group is held off.
   *
   * @throws ActivationException if it is; the message says why and until when
   */
  void requireNotHeldOff() throws ActivationException {
    Optional<Instant> until = heldOffUntil();
    if (until.isPresent()) {
      throw new ActivationException(
          "group "
              + group.name
              + " crashed "
              + crashes.recentCount()
              + " times within "
              + daemon.configuration().restartPolicy().window().toSeconds()
              + " s and is held off until "
              + until.get()
              + "; the last time it "
              + lastFailure);
    }
  }

  /** For people, by the clock as it is set now; what decides is monotonic. */
  private Optional<Instant> heldOffUntil() {
    return crashes
        .remainingHoldOff()
        .map(left -> daemon.clock().instant().plus(left).truncatedTo(ChronoUnit.MILLIS));
  }

  /**
   * What an administrator sees.
   *
   * @param objects how many are registered in the group
   */
  GroupStatus status(Incarnation current, int objects) {
    ProcessIdentity process = current.process();
    return new GroupStatus(
        group.name,
        current.state(),
        current.number(),
        process == null ? -1 : process.pid(),
        current.adopted(),
        objects,
        current.unregistered(),
        crashes.recentCount(),
        crashes.total(),
        crashes.lastCrash().orElse(null),
        heldOffUntil().orElse(null),
        daemon.output(group.name).toString());
  }
}
