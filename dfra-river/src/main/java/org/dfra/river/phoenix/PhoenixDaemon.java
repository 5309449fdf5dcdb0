package org.dfra.river.phoenix;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationInstantiator;
import java.rmi.activation.ActivationSystem;
import java.rmi.activation.Activator;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The daemon's logic: its start and shutdown, and the links between its parts. It contains no
 * network code; the services call it.
 *
 * <pre>
 *   GroupRegistry     what is registered           --&gt; Journal
 *   ManagedGroup      one group's process          --&gt; GroupLauncher
 *   GroupRestarter    what is restarted
 *   DaemonExecutors   delayed and long tasks
 * </pre>
 */
final class PhoenixDaemon {

  private static final Logger LOG = LoggerFactory.getLogger(PhoenixDaemon.class);

  private final PhoenixConfiguration configuration;
  private final InstantSource clock;
  private final Scheduler time;
  private final Journal journal;
  private final DaemonExecutors threads = new DaemonExecutors();
  private final GroupRegistry registered;
  private final GroupRestarter restarts;
  private final GroupLauncher launcher;
  private volatile boolean running = true;

  /**
   * @param clock the system clock, for people
   * @param time monotonic, for decisions
   */
  PhoenixDaemon(
      PhoenixConfiguration configuration, InstantSource clock, Scheduler time, Journal journal) {
    this.configuration = configuration;
    this.clock = clock;
    this.time = time;
    this.journal = journal;
    this.registered = new GroupRegistry(this, journal);
    this.restarts = new GroupRestarter(this, registered);
    this.launcher = new GroupLauncher(this, configuration, journal);
  }

  // Start

  /**
   * Restores the registrations from the journal, adopts the processes that still run, and kills
   * unrecorded processes of registered groups.
   */
  void recover() {
    registered.recover();
  }

  /**
   * Gives groups with a former address of phoenix an identity with the present one. Called before
   * any request for a group.
   */
  void readdress(ActivationSystem system) {
    registered.readdress(system);
  }

  /** Sets the activator that the daemon's IDs carry. */
  void exported(Activator activator) {
    registered.exported(activator);
  }

  /** Activates the inactive objects marked for restart. Called when the services are exported. */
  void scheduleRestarts() {
    registered.groups().forEach(group -> restarts.schedule(group, Duration.ZERO));
  }

  // Parts

  /** What is registered. */
  GroupRegistry groupRegistry() {
    return registered;
  }

  /** Restarts what is marked for it. */
  GroupRestarter groupRestarter() {
    return restarts;
  }

  /** Starts the processes of groups and limits how many start at once. */
  GroupLauncher launcher() {
    return launcher;
  }

  /** Runs delayed and long tasks. */
  DaemonExecutors threads() {
    return threads;
  }

  PhoenixConfiguration configuration() {
    return configuration;
  }

  InstantSource clock() {
    return clock;
  }

  /** Monotonic time. */
  Scheduler time() {
    return time;
  }

  Journal journal() {
    return journal;
  }

  // Processes

  /** Reports the exit of a process to its group; {@code child} if this phoenix started it. */
  void reportExitTo(ManagedGroup group, ProcessIdentity identity, @Nullable Process child) {
    if (child != null) {
      child
          .onExit()
          .thenAccept(ended -> group.onProcessExit(identity, ProcessExit.of(ended.exitValue())));
    } else {
      threads.execute(
          () -> {
            if (identity.awaitExit(Duration.ofDays(36500))) {
              group.onProcessExit(
                  identity,
                  ProcessExit.unrequested(
                      "ended (exit code unknown: it was a former phoenix's child)"));
            }
          });
    }
  }

  /** Kills a process that announced its exit, if it has not exited after a while. */
  void killIfLingering(ProcessIdentity process) {
    threads.after(configuration.unexportTimeout().plusSeconds(2), () -> process.destroy(true));
  }

  /** Prepares an instantiator as configured. */
  ActivationInstantiator prepareInstantiator(ActivationInstantiator raw) throws RemoteException {
    return (ActivationInstantiator) configuration.instantiatorPreparer().prepareProxy(raw);
  }

  /** The file with the output of a group's process. */
  Path output(String group) {
    return configuration.outputDirectory().resolve(group + ".log");
  }

  // Shutdown

  boolean isRunning() {
    return running;
  }

  void requireRunning() throws ActivationException {
    if (!running) {
      throw new ActivationException("phoenix is shutting down; ask the next one");
    }
  }

  /** Ends every process, stops the daemon's own threads, then closes the journal. */
  void stop(Duration timeout) {
    running = false;
    threads.stopScheduling();
    registered.groups().forEach(ManagedGroup::wake);
    // Running effectors may be moving: stop them before waiting for processes that still start.
    processes().forEach(process -> process.destroy(false));
    long end = System.nanoTime() + timeout.toNanos();
    launcher.awaitLaunches(timeout);
    List<ProcessIdentity> processes = processes();
    processes.forEach(process -> process.destroy(false));
    for (ProcessIdentity process : processes) {
      // One timeout for all together: ten processes that do not answer take no longer than one.
      process.awaitExit(Duration.ofNanos(Math.max(0, end - System.nanoTime())));
    }
    processes.forEach(process -> process.destroy(true));
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
    running = false;
    threads.stopScheduling();
    threads.stop();
    try {
      journal.close();
    } catch (IOException e) {
      LOG.warn("The journal did not close well; every acknowledged change is safe in it.", e);
    }
  }
}
