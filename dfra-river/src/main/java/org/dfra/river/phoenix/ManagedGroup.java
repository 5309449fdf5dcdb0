package org.dfra.river.phoenix;

import java.io.IOException;
import java.rmi.MarshalledObject;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationInstantiator;
import java.rmi.activation.UnknownGroupException;
import java.rmi.server.UID;
import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Supplier;
import org.dfra.river.phoenix.GroupStatus.State;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One group of the daemon: the start of its process, the threads that wait for it, and the reaction
 * to its exit. Its {@link Incarnation} has the state of that process.
 *
 * <p>The first thread that needs the process starts it; others wait for the result. The group
 * leaves a process's states only after that process has certainly exited.
 */
final class ManagedGroup {

  private static final Logger LOG = LoggerFactory.getLogger(ManagedGroup.class);

  private static final Duration EXIT_NOTICE_TIMEOUT = Duration.ofSeconds(1);

  final ActivationGroupID id;
  final String name;

  private final PhoenixDaemon daemon;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();
  private final GroupSupervisor supervision; // this and below guarded by lock
  private Incarnation current;

  ManagedGroup(PhoenixDaemon daemon, ActivationGroupID id, String name, long incarnation) {
    this.daemon = daemon;
    this.id = id;
    this.name = name;
    this.current = Incarnation.past(incarnation);
    this.supervision = new GroupSupervisor(daemon, this);
  }

  /** An instantiator and the incarnation it belongs to. */
  record ActiveInstantiator(ActivationInstantiator instantiator, long incarnation) {}

  /**
   * Returns the instantiator of the group's process; starts the process if there is none.
   *
   * @throws ActivationException if it cannot be started, exits during its start, takes too long or
   *     is held off because it crashed too often
   */
  ActiveInstantiator awaitInstantiator() throws ActivationException {
    lock.lock();
    try {
      long nanos = daemon.configuration().groupTimeout().toNanos();
      long awaited = -1;
      while (true) {
        daemon.requireRunning();
        @Nullable ActivationInstantiator instantiator = current.instantiator();
        if (instantiator != null) {
          return new ActiveInstantiator(instantiator, current.number());
        }
        if (current.state() == State.IDLE) {
          if (awaited == current.number()) {
            throw supervision.failure();
          }
          supervision.requireNotHeldOff();
          awaited = current.number() + 1;
          launch();
          continue;
        }
        if (current.state() == State.STARTING) {
          // An adopted one may exit because the former daemon did not send it everything.
          awaited = current.adopted() ? -1 : current.number();
        }
        if (nanos <= 0) {
          throw supervision.timeoutFailure();
        }
        nanos = changed.awaitNanos(nanos);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new ActivationException("interrupted while group " + name + " started", e);
    } finally {
      lock.unlock();
    }
  }

  private <T> T locked(Supplier<T> question) {
    lock.lock();
    try {
      return question.get();
    } finally {
      lock.unlock();
    }
  }

  /** The instantiator of the group's process; empty if there is none. Starts nothing. */
  Optional<ActiveInstantiator> active() {
    lock.lock();
    try {
      @Nullable ActivationInstantiator instantiator = current.instantiator();
      return instantiator == null
          ? Optional.empty()
          : Optional.of(new ActiveInstantiator(instantiator, current.number()));
    } finally {
      lock.unlock();
    }
  }

  /** The group's name without the number that phoenix gave it: {@code robot.group}. */
  String plainName() {
    return name.substring(name.indexOf('-') + 1);
  }

  /** The name of its robot; empty for a group of no robot. */
  String robot() {
    String plain = plainName();
    int dot = plain.indexOf('.');
    return dot < 0 ? "" : plain.substring(0, dot);
  }

  /** Starts a process. Releases the lock while it waits for a launch permit and forks. */
  private void launch() throws ActivationException {
    current = current.next();
    long mine = current.number();
    lock.unlock();
    try {
      daemon.launcher().launch(this, mine);
    } catch (IOException e) {
      notLaunched(mine, "could not be started: " + e.getMessage());
      throw new ActivationException(
          "group " + name + " cannot be started: " + e.getMessage() + "; mend its command", e);
    } catch (ActivationException | RuntimeException e) {
      notLaunched(mine, "could not be started: " + e.getMessage());
      throw new ActivationException("group " + name + " is not started: " + e.getMessage(), e);
    } finally {
      lock.lock();
    }
  }

  private void notLaunched(long number, String how) {
    lock.lock();
    try {
      if (current.number() == number && current.process() == null) {
        ended(ProcessExit.unrequested(how));
      }
    } finally {
      lock.unlock();
    }
  }

  /** Records the process that was started for an incarnation, before it receives its group. */
  void launched(ProcessIdentity started) {
    lock.lock();
    try {
      current.launched(started);
    } finally {
      lock.unlock();
    }
  }

  /** Adopts a process that a former daemon started. */
  void adopt(
      ProcessIdentity found,
      @Nullable ActivationInstantiator known,
      boolean leaving,
      Set<UID> unregistered) {
    lock.lock();
    try {
      current.adopt(found, known, leaving);
      unregistered.forEach(current::addUnregistered);
      LOG.info("Took back group {}: process {} is {}.", name, found.pid(), current.state());
    } finally {
      lock.unlock();
    }
  }

  /**
   * Records that the group's process instantiates objects.
   *
   * @throws ActivationException if it is not the process that was started last, or another one has
   *     reported before it
   */
  void reported(ActivationInstantiator reporter, long itsIncarnation) throws ActivationException {
    lock.lock();
    try {
      if (current.isRepeatedReport(name, reporter, itsIncarnation)) {
        return;
      }
      daemon.journal().commit(new Change.Reported(id, new MarshalledObject<>(reporter)));
      current.reported(reporter);
      releaseLaunchPermit();
      changed.signalAll();
      @Nullable ProcessIdentity process = current.process();
      LOG.info(
          "Group {} is up: incarnation {}, process {}.",
          name,
          current.number(),
          process == null ? "?" : process.pid());
    } catch (IOException e) {
      throw new ActivationException("the instantiator of group " + name + " cannot be kept", e);
    } finally {
      lock.unlock();
    }
  }

  /**
   * Records that the group's process instantiates no more objects and is exiting.
   *
   * @throws UnknownGroupException if it is not the process that was started last
   */
  void onLeaving(long itsIncarnation) throws UnknownGroupException {
    lock.lock();
    try {
      if (itsIncarnation != current.number() || current.state() == State.IDLE) {
        throw new UnknownGroupException(
            "incarnation " + itsIncarnation + " of group " + name + " is not the current one");
      }
      leave();
    } finally {
      lock.unlock();
    }
  }

  private void leave() {
    if (current.state() == State.LEAVING) {
      return;
    }
    current.setLeaving();
    changed.signalAll();
    supervision.leaves(current.process());
  }

  private void releaseLaunchPermit() {
    if (current.takeLaunchPermit()) {
      daemon.launcher().releasePermit();
    }
  }

  /**
   * Records that an instantiator cannot be used: it instantiates no more objects, or it cannot be
   * reached.
   *
   * @param unreachable whether to kill its process, since no call reaches it
   */
  void unusable(ActiveInstantiator maker, boolean unreachable) {
    @Nullable ProcessIdentity condemned = null;
    lock.lock();
    try {
      if (!current.isActive(maker.incarnation())) {
        return;
      }
      if (unreachable) {
        condemned = current.process();
      } else {
        leave();
      }
    } finally {
      lock.unlock();
    }
    if (condemned != null) {
      condemned.destroy(true);
      if (condemned.awaitExit(daemon.configuration().groupTimeout())) {
        awaitNotice(condemned);
        onProcessExit(condemned, ProcessExit.unrequested("could not be reached and was ended"));
      }
    }
  }

  /** Waits for the thread that watches the process: it reports how the process exited. */
  private void awaitNotice(ProcessIdentity dead) {
    lock.lock();
    try {
      long nanos = EXIT_NOTICE_TIMEOUT.toNanos();
      while (nanos > 0 && dead.equals(current.process())) {
        nanos = changed.awaitNanos(nanos);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      lock.unlock();
    }
  }

  /**
   * Records that a process of this group exited. If it was the current one and had not announced
   * its exit, this is a crash.
   */
  void onProcessExit(ProcessIdentity who, ProcessExit exit) {
    lock.lock();
    try {
      if (who.equals(current.process())) {
        ended(exit);
      }
    } finally {
      lock.unlock();
    }
  }

  private void ended(ProcessExit how) {
    boolean announced = current.state() == State.LEAVING;
    releaseLaunchPermit();
    boolean worked = daemon.groupRestarter().wasStable(this, current.number());
    current.ended();
    changed.signalAll();
    supervision.ended(how, announced, worked);
  }

  /** Whether this incarnation is active now. */
  boolean isActive(long itsIncarnation) {
    return locked(() -> current.isActive(itsIncarnation));
  }

  /** Whether a former daemon started the present process. */
  boolean isAdopted() {
    return locked(() -> current.adopted() && current.state() == State.ACTIVE);
  }

  /** The incarnation started last. */
  long incarnation() {
    return locked(() -> current.number());
  }

  /** Records that an object was unregistered that an incarnation's process may have. */
  void addUnregistered(UID unregistered, long itsIncarnation) {
    lock.lock();
    try {
      if (current.number() == itsIncarnation) {
        current.addUnregistered(unregistered);
      }
    } finally {
      lock.unlock();
    }
  }

  /** Records that its process dropped an unregistered object; false if it had no such one. */
  boolean removeUnregistered(UID unregistered) {
    return locked(() -> current.removeUnregistered(unregistered));
  }

  /**
   * Records that the group was unregistered: its process may run on, but is ignored from now on.
   */
  void setUnregistered() {
    lock.lock();
    try {
      supervision.ignoreExits();
    } finally {
      lock.unlock();
    }
  }

  /** The group's process, if there is one. */
  Optional<ProcessIdentity> process() {
    return locked(() -> Optional.ofNullable(current.process()));
  }

  /** Kills a process that has still not reported. */
  void killUnlessReported(ProcessIdentity who) {
    lock.lock();
    try {
      if (current.state() == State.STARTING && who.equals(current.process())) {
        LOG.warn("Group {}: process {} never reported and is ended.", name, who.pid());
        who.destroy(true);
      }
    } finally {
      lock.unlock();
    }
  }

  /** The state for the administrator. */
  GroupStatus status(int objects) {
    return locked(() -> supervision.status(current, objects));
  }

  /** Wakes the waiting threads when the daemon shuts down. */
  void wake() {
    lock.lock();
    try {
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }
}
