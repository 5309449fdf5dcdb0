package org.dfra.river.phoenix;

import java.io.IOException;
import java.rmi.MarshalledObject;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.time.Duration;
import java.util.UUID;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantReadWriteLock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Starts the processes of groups; the configuration limits how many start at once. */
final class GroupLauncher {

  private static final Logger LOG = LoggerFactory.getLogger(GroupLauncher.class);

  private final PhoenixConfiguration configuration;
  private final Journal journal;
  private final DaemonState state;
  private final ProcessWatcher watcher;

  /** One permit for each group that is starting, until it has reported or exited. */
  private final Semaphore launches;

  /** Read lock: starts a process. Write lock: ensures that no process is being started. */
  private final ReentrantReadWriteLock starting = new ReentrantReadWriteLock();

  GroupLauncher(
      PhoenixConfiguration configuration,
      Journal journal,
      DaemonState state,
      ProcessWatcher watcher) {
    this.configuration = configuration;
    this.journal = journal;
    this.state = state;
    this.watcher = watcher;
    this.launches = new Semaphore(configuration.groupThrottle());
  }

  /** The owner of a process that is being started. */
  interface LaunchOwner extends ProcessWatcher.ProcessOwner {

    /**
     * Records the process that was started for an incarnation, before it receives its group.
     *
     * @throws ActivationException if that incarnation does not await a process any more; then the
     *     process is killed
     */
    void launched(long incarnation, ProcessIdentity started) throws ActivationException;
  }

  /**
   * Acquires a launch permit and starts a process for an incarnation of a group. The configuration
   * limits the permits. {@link #releasePermit} releases it.
   *
   * @param owner receives the process, and its exit
   * @throws IOException if the process cannot be started
   * @throws ActivationException if it must not be, or cannot be recorded
   */
  void launch(ActivationGroupID group, String name, long incarnation, LaunchOwner owner)
      throws IOException, ActivationException {
    launches.acquireUninterruptibly();
    starting.readLock().lock();
    boolean handedOver = false;
    try {
      state.requireRunning();
      journal.commit(new JournalRecord.Launching(group, incarnation));
      ActivationGroupDesc desc = withDefaults(journal.groupDesc(group));
      Process process =
          GroupProcess.start(journal.<UUID>read(r -> r.daemon), name, desc, configuration);
      try {
        ProcessIdentity identity = ProcessIdentity.of(process.toHandle());
        journal.commit(new JournalRecord.Launched(group, identity));
        owner.launched(incarnation, identity);
        handedOver = true;
        watcher.reportExit(owner, identity, process);
        watcher.limitReport(owner, identity);
        GroupProcess.sendGroup(process, group, desc, incarnation);
      } catch (IOException e) {
        LOG.debug("Group {} ended before its description was sent.", name, e);
      } catch (ActivationException | RuntimeException e) {
        process.destroyForcibly();
        throw e;
      }
    } finally {
      starting.readLock().unlock();
      if (!handedOver) {
        launches.release();
      }
    }
  }

  /** Releases the launch permit of a group that has reported or exited. */
  void releasePermit() {
    launches.release();
  }

  private ActivationGroupDesc withDefaults(ActivationGroupDesc desc) throws IOException {
    boolean custom = desc.getClassName() != null;
    return new ActivationGroupDesc(
        custom ? desc.getClassName() : ActivationGroupImpl.class.getName(),
        custom ? desc.getLocation() : configuration.groupLocation(),
        desc.getData() != null || configuration.groupConfig() == null
            ? desc.getData()
            : new MarshalledObject<>(configuration.groupConfig()),
        desc.getPropertyOverrides(),
        desc.getCommandEnvironment());
  }

  /**
   * Waits for the launches in progress, so that their processes are known, and blocks further ones.
   */
  void awaitLaunches(Duration timeout) {
    try {
      if (starting.writeLock().tryLock(timeout.toNanos(), TimeUnit.NANOSECONDS)) {
        starting.writeLock().unlock();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
