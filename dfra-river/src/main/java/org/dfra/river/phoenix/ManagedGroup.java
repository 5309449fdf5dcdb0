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
 * One group as the daemon sees it: who starts its process, who waits for it, and what its end leads
 * to. What is known of that process is its {@link Incarnation}.
 *
 * <p>A start is made by the thread that needs it; others wait for its outcome. The group leaves a
 * process's states only when that process is proven dead.
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
   * The instantiator of the group's process, which is started where there is none.
   *
   * @throws ActivationException if it cannot be started, ends while it starts, takes too long or is
   *     held off because it crashed too often
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
          // One that a former daemon started may end because that one could not tell it all.
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

  /** The instantiator of the group's process; empty where there is none. Starts nothing. */
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

  /** Starts a process. Gives up the lock while it waits for its turn and forks. */
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

  /** Notes the process that was started for an incarnation, before it is told its group. */
  void launched(ProcessIdentity started) {
    lock.lock();
    try {
      current.launched(started);
    } finally {
      lock.unlock();
    }
  }

  /** Takes back a process that a former daemon started. */
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
   * The group's process reports that it makes objects.
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
   * The group's process makes no more objects and will end.
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
   * An instantiator cannot be used: it makes no objects any more, or it cannot be reached.
   *
   * @param unreachable whether its process is to be ended, since nobody can talk to it
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

  /** Whoever watches the process knows better how it ended, and is about to tell. */
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
   * A process of this group has ended. Where it was the current one, and it had not said that it
   * would, that is a crash.
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

  /** Whether this incarnation is the one that works now. */
  boolean isActive(long itsIncarnation) {
    return locked(() -> current.isActive(itsIncarnation));
  }

  /** Whether a former daemon started the process that works now. */
  boolean isAdopted() {
    return locked(() -> current.adopted() && current.state() == State.ACTIVE);
  }

  /** The incarnation started last. */
  long incarnation() {
    return locked(() -> current.number());
  }

  /** An object of the group was unregistered, which the process of an incarnation may have. */
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

  /** Its process has an unregistered object no longer; false where it had none of that name. */
  boolean removeUnregistered(UID unregistered) {
    return locked(() -> current.removeUnregistered(unregistered));
  }

  /** The group was unregistered: its process may live on, but is nobody's business here. */
  void setUnregistered() {
    lock.lock();
    try {
      supervision.ignoreExits();
    } finally {
      lock.unlock();
    }
  }

  /** The group's process, where there is one. */
  Optional<ProcessIdentity> process() {
    return locked(() -> Optional.ofNullable(current.process()));
  }

  /** Ends a process that has still not reported. */
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

  /** What an administrator sees. */
  GroupStatus status(int objects) {
    return locked(() -> supervision.status(current, objects));
  }

  /** Makes waiters look again, for the end of the daemon. */
  void wake() {
    lock.lock();
    try {
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }
}
