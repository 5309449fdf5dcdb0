package org.dfra.river.phoenix;

import java.rmi.activation.ActivationException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.time.temporal.ChronoUnit;
import java.util.Optional;
import org.dfra.river.phoenix.restart.CrashHistory;
import org.dfra.river.phoenix.restart.CrashHistory.ProcessExit;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Decides what follows the exit of a group's process: nothing if the exit was announced, else a
 * restart after a delay, or a hold-off after too many crashes. It also supplies the exceptions for
 * threads that wait for the process. Confined to the group's lock.
 */
final class GroupSupervisor {

  private static final Logger LOG = LoggerFactory.getLogger(GroupSupervisor.class);

  private final String name;
  private final PhoenixConfiguration configuration;
  private final InstantSource clock;
  private final DaemonState state;
  private final CrashHistory crashes;
  private boolean forgotten;
  private String lastFailure = "";

  /**
   * @param name the group's name, for messages and files
   * @param clock the system clock, for people
   * @param crashes the group's, still empty
   */
  GroupSupervisor(
      String name,
      PhoenixConfiguration configuration,
      InstantSource clock,
      DaemonState state,
      CrashHistory crashes) {
    this.name = name;
    this.configuration = configuration;
    this.clock = clock;
    this.state = state;
    this.crashes = crashes;
  }

  /** Records that the group was unregistered: later exits of its process are no crashes. */
  void ignoreExits() {
    forgotten = true;
  }

  /** Records that the group's process exited as expected, for example as it had announced. */
  void recordExpectedExit(ProcessExit end) {
    lastFailure = failure(end);
    LOG.info("Group {} {}.", name, end.description());
  }

  private String failure(ProcessExit end) {
    return end.description() + "; see " + configuration.output(name) + " and the .vm.log beside it";
  }

  /**
   * Records that the group's process exited without announcing it, or was never launched. This is a
   * crash, unless the group is unregistered or the daemon is shutting down.
   *
   * @param wasStable whether its modules were stable in it
   * @return the delay after which the group's objects are to be restarted; empty if they are not
   */
  Optional<Duration> recordExit(ProcessExit end, boolean wasStable) {
    if (forgotten || !state.isRunning()) {
      recordExpectedExit(end);
      return Optional.empty();
    }
    String how = end.description();
    lastFailure = failure(end);
    if (end.isRequested()) {
      crashes.recordRequestedExit(wasStable);
    } else {
      crashes.recordCrash(how, wasStable);
    }
    LOG.warn("Group {} {} ({} recent crashes).", name, how, crashes.recentCount());
    Optional<Duration> delay = crashes.restartDelay();
    if (delay.isEmpty()) {
      LOG.error(
          "Group {} crashed {} times within {} s: it is not restarted before {}, and then only by"
              + " the next call. See {}.",
          name,
          crashes.recentCount(),
          configuration.restartPolicy().window().toSeconds(),
          heldOffUntil().map(Instant::toString).orElse("now"),
          configuration.output(name));
    }
    return delay;
  }

  /** The exception for waiting threads if the group's process was not ready in time. */
  ActivationException timeoutFailure() {
    return new ActivationException(
        "group "
            + name
            + " was not ready within "
            + configuration.groupTimeout().toMillis()
            + " ms; see "
            + configuration.output(name));
  }

  /** The exception for waiting threads: how the group's process ended the last time. */
  ActivationException failure() {
    return new ActivationException("group " + name + " " + lastFailure);
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
              + name
              + " crashed "
              + crashes.recentCount()
              + " times within "
              + configuration.restartPolicy().window().toSeconds()
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
        .map(left -> clock.instant().plus(left).truncatedTo(ChronoUnit.MILLIS));
  }

  /**
   * The state for the administrator.
   *
   * @param objects how many are registered in the group
   */
  GroupStatus status(GroupIncarnation current, int objects) {
    ProcessIdentity process = current.process();
    return new GroupStatus(
        name,
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
        configuration.output(name).toString());
  }
}
