package org.dfra.river.phoenix;

import java.io.IOException;
import java.rmi.activation.ActivationSystem;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import org.dfra.river.phoenix.restart.CrashHistory;
import org.dfra.river.phoenix.restart.RestartPolicy;
import org.dfra.time.Scheduler;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The daemon's logic: it creates and connects the daemon's parts, starts them and shuts them down.
 * It contains no network code; the services call its registry and its table of groups.
 *
 * <pre>
 *   GroupRegistry     changes what is registered   --&gt; Journal, GroupTable
 *   GroupTable        what is registered           --&gt; ManagedGroup, ActivatableObject
 *   ManagedGroup      one group's process          --&gt; GroupLauncher
 *   GroupRestarter    what is restarted            --&gt; GroupTable
 *   JournalRecovery   what a former daemon left    --&gt; Journal, GroupTable
 *   DaemonExecutors   delayed and long tasks
 * </pre>
 */
final class PhoenixDaemon {

  private static final Logger LOG = LoggerFactory.getLogger(PhoenixDaemon.class);

  private final Journal journal;
  private final DaemonState state;
  private final DaemonExecutors threads;
  private final GroupTable registered;
  private final GroupRestarter restarts;
  private final GroupLauncher launcher;
  private final GroupRegistry registry;
  private final JournalRecovery recovery;

  /**
   * @param clock the system clock, for people
   * @param time monotonic, for decisions
   */
  PhoenixDaemon(
      PhoenixConfiguration configuration, InstantSource clock, Scheduler time, Journal journal) {
    // Local variables, since the factory below must not refer to this.
    DaemonState state = new DaemonState();
    DaemonExecutors threads = new DaemonExecutors();
    GroupTable registered = new GroupTable();
    RestartPolicy policy = configuration.restartPolicy();
    Duration timeout = configuration.groupTimeout();
    ProcessWatcher watcher = new ProcessWatcher(threads, timeout, configuration.unexportTimeout());
    GroupRestarter restarts = new GroupRestarter(registered, threads, state, policy);
    GroupLauncher launcher = new GroupLauncher(configuration, journal, state, watcher);
    ManagedGroup.Factory groups =
        (id, name, incarnation) ->
            new ManagedGroup(
                id,
                name,
                GroupIncarnation.past(incarnation),
                new GroupSupervisor(
                    name, configuration, clock, state, new CrashHistory(policy, time::nanos)),
                timeout,
                journal,
                state,
                watcher,
                launcher,
                restarts);
    this.journal = journal;
    this.state = state;
    this.threads = threads;
    this.registered = registered;
    this.restarts = restarts;
    this.launcher = launcher;
    this.registry =
        new GroupRegistry(journal, configuration.execPolicy(), state, groups, registered);
    this.recovery = new JournalRecovery(journal, configuration, watcher, groups, registered);
  }

  // Start

  /**
   * Restores the registrations from the journal, adopts the processes that still run, and kills
   * unrecorded processes of registered groups.
   */
  void recover() {
    recovery.recover();
  }

  /**
   * Gives groups with a former address of phoenix an identity with the present one. Called before
   * any request for a group.
   */
  void updateAddress(ActivationSystem system) {
    registry.updateAddress(system);
  }

  /** Activates the inactive objects marked for restart. Called when the services are exported. */
  void scheduleRestarts() {
    registered.groups().forEach(group -> restarts.schedule(group, Duration.ZERO));
  }

  // Parts

  /** What is registered, in memory. */
  GroupTable groupTable() {
    return registered;
  }

  /** Changes what is registered. */
  GroupRegistry groupRegistry() {
    return registry;
  }

  // Shutdown

  /** Whether the daemon is not shutting down. */
  boolean isRunning() {
    return state.isRunning();
  }

  /** Ends every process, stops the daemon's own threads, then closes the journal. */
  void stop(Duration timeout) {
    state.setEnding();
    threads.stopScheduling();
    registered.groups().forEach(ManagedGroup::wake);
    // Running effectors may be moving: stop them before waiting for processes that still start.
    processes().forEach(process -> process.terminate());
    long end = System.nanoTime() + timeout.toNanos();
    launcher.awaitLaunches(timeout);
    List<ProcessIdentity> processes = processes();
    processes.forEach(process -> process.terminate());
    for (ProcessIdentity process : processes) {
      // One timeout for all together: ten processes that do not answer take no longer than one.
      process.awaitExit(Duration.ofNanos(Math.max(0, end - System.nanoTime())));
    }
    processes.forEach(process -> process.kill());
    processes.forEach(process -> process.awaitExit(timeout));
    stopKeepingProcesses();
  }

  private List<ProcessIdentity> processes() {
    return registered.groups().stream().flatMap(group -> group.process().stream()).toList();
  }

  /**
   * Stops the daemon's own threads and closes the journal; the groups' processes continue to run.
   */
  void stopKeepingProcesses() {
    state.setEnding();
    threads.stopScheduling();
    threads.stop();
    try {
      journal.close();
    } catch (IOException e) {
      LOG.warn("The journal did not close well; every acknowledged change is safe in it.", e);
    }
  }
}
