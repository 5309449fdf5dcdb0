package org.dfra.river.phoenix;

import com.google.errorprone.annotations.concurrent.GuardedBy;
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
import org.dfra.river.phoenix.restart.CrashHistory.ProcessExit;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One group of the daemon: the start of its process, the threads that wait for it, and the reaction
 * to its exit. Its {@link GroupIncarnation} has the state of that process.
 *
 * <p>The first thread that needs the process starts it; others wait for the result. The group
 * leaves a process's states only after that process has certainly exited.
 */
final class ManagedGroup implements GroupLauncher.LaunchOwner {

  private static final Logger LOG = LoggerFactory.getLogger(ManagedGroup.class);

  private static final Duration EXIT_NOTICE_TIMEOUT = Duration.ofSeconds(1);

  final ActivationGroupID id;
  final String name;

  private final Duration timeout;
  private final Journal journal;
  private final DaemonState state;
  private final ProcessWatcher watcher;
  private final GroupLauncher launcher;
  private final Restarts restarts;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();

  @GuardedBy("lock")
  private final GroupSupervisor supervision;

  private volatile GroupIncarnation current; // changed under the lock

  /**
   * @param timeout the longest wait for the start of its process, and for the exit of a process
   *     that was killed
   */
  ManagedGroup(
      ActivationGroupID id,
      String name,
      GroupIncarnation last,
      GroupSupervisor supervision,
      Duration timeout,
      Journal journal,
      DaemonState state,
      ProcessWatcher watcher,
      GroupLauncher launcher,
      Restarts restarts) {
    this.id = id;
    this.name = name;
    this.current = last;
    this.supervision = supervision;
    this.timeout = timeout;
    this.journal = journal;
    this.state = state;
    this.watcher = watcher;
    this.launcher = launcher;
    this.restarts = restarts;
  }

  /** Creates the daemon's groups. */
  interface Factory {

    /**
     * Creates a group without a process.
     *
     * @param incarnation the number of its last process; 0 if it never had one
     */
    ManagedGroup create(ActivationGroupID id, String name, long incarnation);
  }

  /** What follows the exit of a group's process. Called under the group's lock; must not block. */
  interface Restarts {

    /** Whether the modules of a group were stable in an incarnation. */
    boolean wasStable(ManagedGroup group, long incarnation);

    /** Activates those objects of a group that are marked for restart, after a delay. */
    void schedule(ManagedGroup group, Duration delay);
  }

  /** An instantiator and the incarnation it belongs to. */
  record ActiveInstantiator(ActivationInstantiator instantiator, long incarnation) {}

  /**
   * Returns the instantiator of the group's process; starts the process if there is none.
   *
   * <p>A start takes long: it waits for a launch permit and forks. So it happens without the lock,
   * and an emergency stop never waits for it. {@link #awaitStep} decides under the lock who starts
   * the process, {@link #launch} starts it without, and {@link #launched} or {@link #notLaunched}
   * records the result under the lock again.
   *
   * @throws ActivationException if it cannot be started, exits during its start, takes too long or
   *     is held off because it crashed too often
   */
  ActiveInstantiator awaitInstantiator() throws ActivationException {
    ProcessWait waiting = new ProcessWait(timeout);
    while (true) {
      @Nullable ActiveInstantiator active = awaitStep(waiting);
      if (active != null) {
        return active;
      }
      launch(waiting.awaited);
    }
  }

  /** How long a thread waits for the process, and for which. Confined to that thread. */
  private static final class ProcessWait {
    private static final long NONE = -1;

    private long nanos;

    /** The incarnation whose end is a failure of the wait. */
    private long awaited = NONE;

    ProcessWait(Duration timeout) {
      nanos = timeout.toNanos();
    }
  }

  /**
   * Waits until the process instantiates objects, or until this thread has to start it.
   *
   * @return the instantiator; null if the caller must now {@link #launch} the awaited incarnation,
   *     which no other thread does
   */
  private @Nullable ActiveInstantiator awaitStep(ProcessWait waiting) throws ActivationException {
    lock.lock();
    try {
      while (true) {
        state.requireRunning();
        @Nullable ActivationInstantiator instantiator = current.instantiator();
        if (instantiator != null) {
          return new ActiveInstantiator(instantiator, current.number());
        }
        if (current.state() == State.IDLE) {
          if (waiting.awaited == current.number()) {
            throw supervision.failure();
          }
          supervision.requireNotHeldOff();
          current = current.next(); // STARTING: further threads wait for it
          waiting.awaited = current.number();
          return null;
        }
        if (current.state() == State.STARTING) {
          // An adopted one may exit because the former daemon did not send it everything.
          waiting.awaited = current.adopted() ? ProcessWait.NONE : current.number();
        }
        if (waiting.nanos <= 0) {
          throw supervision.timeoutFailure();
        }
        waiting.nanos = changed.awaitNanos(waiting.nanos);
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

  /**
   * The instantiator of the group's process; empty if there is none. Starts nothing, and waits for
   * nothing: an emergency stop calls it, while another thread may write to the journal under the
   * lock.
   */
  Optional<ActiveInstantiator> active() {
    GroupIncarnation last = current;
    @Nullable ActivationInstantiator instantiator = last.instantiator();
    return instantiator == null
        ? Optional.empty()
        : Optional.of(new ActiveInstantiator(instantiator, last.number()));
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

  /** Starts the process of an incarnation. Called without the lock, by the thread that began it. */
  private void launch(long incarnation) throws ActivationException {
    try {
      launcher.launch(id, name, incarnation, this);
    } catch (IOException e) {
      notLaunched(incarnation, "could not be started: " + e.getMessage());
      throw new ActivationException(
          "group " + name + " cannot be started: " + e.getMessage() + "; correct its command", e);
    } catch (ActivationException | RuntimeException e) {
      notLaunched(incarnation, "could not be started: " + e.getMessage());
      throw new ActivationException("group " + name + " is not started: " + e.getMessage(), e);
    } catch (Error e) { // out of threads, for example: the next activation tries again
      notLaunched(incarnation, "could not be started: " + e);
      throw e;
    }
  }

  /** Records that no process was started for an incarnation, unless one was. */
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

  @Override
  public void launched(long incarnation, ProcessIdentity started) throws ActivationException {
    lock.lock();
    try {
      current.requireUnlaunched(name, incarnation);
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
      LOG.info("Adopted group {}: its process {} is {}.", name, found.pid(), current.state());
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
      journal.commit(new JournalRecord.Reported(id, new MarshalledObject<>(reporter)));
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
      throw new ActivationException("the instantiator of group " + name + " cannot be stored", e);
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

  /**
   * Records that the process has announced its exit; kills it later if necessary. If the record
   * cannot be written, nothing is lost. A later daemon takes the process for an active one, calls
   * it for an object, and receives the same announcement.
   */
  private void leave() {
    if (current.state() == State.LEAVING) {
      return;
    }
    current.setLeaving();
    changed.signalAll();
    LOG.info("Group {} has nothing left to do; its process ends.", name);
    @Nullable ProcessIdentity process = current.process();
    if (process != null) { // else it is not launched yet
      watcher.killIfLingering(process);
    }
    try {
      journal.commit(new JournalRecord.Left(id));
    } catch (ActivationException e) {
      LOG.warn("The end of group {} is not recorded: {}", name, e.getMessage());
    }
  }

  private void releaseLaunchPermit() {
    if (current.takeLaunchPermit()) {
      launcher.releasePermit();
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
      condemned.kill();
      if (condemned.awaitExit(timeout)) {
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
  @Override
  public void onProcessExit(ProcessIdentity process, ProcessExit exit) {
    lock.lock();
    try {
      if (process.equals(current.process())) {
        ended(exit);
      }
    } finally {
      lock.unlock();
    }
  }

  @GuardedBy("lock")
  private void ended(ProcessExit how) {
    boolean announced = current.state() == State.LEAVING;
    releaseLaunchPermit();
    boolean worked = restarts.wasStable(this, current.number());
    current.ended();
    changed.signalAll();
    if (announced) {
      supervision.recordExpectedExit(how);
    } else {
      supervision.recordExit(how, worked).ifPresent(delay -> restarts.schedule(this, delay));
    }
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

  @Override
  public void killUnlessReported(ProcessIdentity process) {
    lock.lock();
    try {
      if (current.state() == State.STARTING && process.equals(current.process())) {
        LOG.warn("Group {}: process {} never reported and is ended.", name, process.pid());
        process.kill();
      }
    } finally {
      lock.unlock();
    }
  }

  /** The state for the administrator. */
  GroupStatus status(int objects) {
    lock.lock();
    try {
      return supervision.status(current, objects);
    } finally {
      lock.unlock();
    }
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
