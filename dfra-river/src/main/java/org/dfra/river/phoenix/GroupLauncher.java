package org.dfra.river.phoenix;

import java.io.IOException;
import java.rmi.MarshalledObject;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
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

  private final PhoenixDaemon daemon;
  private final PhoenixConfiguration configuration;
  private final Journal journal;

  /** One permit for each group that is starting, until it has reported or exited. */
  private final Semaphore launches;

  /** Read lock: starts a process. Write lock: ensures that no process is being started. */
  private final ReentrantReadWriteLock starting = new ReentrantReadWriteLock();

  GroupLauncher(PhoenixDaemon daemon, PhoenixConfiguration configuration, Journal journal) {
    this.daemon = daemon;
    this.configuration = configuration;
    this.journal = journal;
    this.launches = new Semaphore(configuration.groupThrottle());
  }

  /**
   * Acquires a launch permit and starts a process for an incarnation of a group. The configuration
   * limits the permits. {@link #releasePermit} releases it.
   *
   * @throws IOException if the process cannot be started
   * @throws ActivationException if it must not be, or cannot be recorded
   */
  void launch(ManagedGroup group, long incarnation) throws IOException, ActivationException {
    launches.acquireUninterruptibly();
    starting.readLock().lock();
    boolean handedOver = false;
    try {
      daemon.requireRunning();
      journal.commit(new Change.Launching(group.id, incarnation));
      ActivationGroupDesc desc = withDefaults(daemon.groupRegistry().groupDesc(group.id));
      Process process =
          GroupProcess.start(journal.<UUID>read(r -> r.daemon), group.name, desc, configuration);
      try {
        ProcessIdentity identity = ProcessIdentity.of(process.toHandle());
        journal.commit(new Change.Launched(group.id, identity));
        group.launched(identity);
        handedOver = true;
        daemon.reportExitTo(group, identity, process);
        daemon
            .threads()
            .after(configuration.groupTimeout(), () -> group.killUnlessReported(identity));
        GroupProcess.sendGroup(process, group.id, desc, incarnation);
      } catch (IOException e) {
        LOG.debug("Group {} ended before it could be told what it is.", group.name, e);
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
