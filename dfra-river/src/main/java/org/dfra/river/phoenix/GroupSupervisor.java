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
 * Decides what follows the exit of a group's process: nothing if the exit was announced, else a
 * restart after a delay, or a hold-off after too many crashes. It also supplies the exceptions for
 * threads that wait for the process. Confined to the group's lock.
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

  /** Records that the group was unregistered: later exits of its process are no crashes. */
  void ignoreExits() {
    forgotten = true;
  }

  /**
   * Records that the group's process has announced its exit; kills it later if necessary. If the
   * record cannot be written, nothing is lost. A later daemon takes the process for an active one,
   * calls it for an object, and receives the same announcement.
   *
   * @param process null if it is not launched yet
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
   * Records that the group's process exited, or was never launched. This is a crash, unless the
   * exit was announced, the group is unregistered or the daemon is shutting down.
   *
   * @param wasAnnounced whether the process had announced its exit
   * @param wasStable whether its modules were stable in it
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

  /** The exception for waiting threads if the group's process was not ready in time. */
  ActivationException timeoutFailure() {
    return new ActivationException(
        "group "
            + group.name
            + " was not ready within "
            + daemon.configuration().groupTimeout().toMillis()
            + " ms; see "
            + daemon.output(group.name));
  }

  /** The exception for waiting threads: how the group's process ended the last time. */
  ActivationException failure() {
    return new ActivationException("group " + group.name + " " + lastFailure);
  }

  /**
   * Refuses a start while the group is held off.
   *
   * @throws ActivationException if it is; the message has the reason and the end of the hold-off
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

  /** By the present wall clock, for people; decisions use monotonic time. */
  private Optional<Instant> heldOffUntil() {
    return crashes
        .remainingHoldOff()
        .map(left -> daemon.clock().instant().plus(left).truncatedTo(ChronoUnit.MILLIS));
  }

  /**
   * The state for the administrator.
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
