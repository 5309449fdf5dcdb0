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
 * The daemon's logic: its beginning and end, and what its parts need of each other. It knows no
 * network; the services in front of it do.
 *
 * <pre>
 *   GroupRegistry   what is registered           --&gt; Journal
 *   Group              one group's process          --&gt; Launcher
 *   Restarts           what is started again
 *   DaemonExecutors      what is due later, and what takes long
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
   * @param clock the computer's, for people
   * @param time what decides
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

  // The beginning

  /**
   * Takes up what the journal says: registers everything again, takes back the processes that still
   * live, and ends those of registered groups that no journal entry knows.
   */
  void recover() {
    registered.recover();
  }

  /**
   * Gives the groups that know phoenix at a former address an identity that names this one. Called
   * before anybody can ask for a group.
   */
  void readdress(ActivationSystem system) {
    registered.readdress(system);
  }

  /** Tells the daemon the activator that its IDs carry. */
  void exported(Activator activator) {
    registered.exported(activator);
  }

  /** Restarts what is marked so and is not active. Called when the services are exported. */
  void scheduleRestarts() {
    registered.groups().forEach(group -> restarts.schedule(group, Duration.ZERO));
  }

  // Its parts

  /** What is registered. */
  GroupRegistry groupRegistry() {
    return registered;
  }

  /** Starts again what is marked so. */
  GroupRestarter groupRestarter() {
    return restarts;
  }

  /** Starts and counts the processes of groups. */
  GroupLauncher launcher() {
    return launcher;
  }

  /** What runs later, or takes long. */
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

  /** Has the group told when its process ends; {@code child} where this phoenix started it. */
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

  /** Ends a process that said it would end, if it has not done so in a while. */
  void killIfLingering(ProcessIdentity process) {
    threads.after(configuration.unexportTimeout().plusSeconds(2), () -> process.destroy(true));
  }

  /** An instantiator prepared as configured. */
  ActivationInstantiator prepareInstantiator(ActivationInstantiator raw) throws RemoteException {
    return (ActivationInstantiator) configuration.instantiatorPreparer().prepareProxy(raw);
  }

  /** The file with what a group's process prints. */
  Path output(String group) {
    return configuration.outputDirectory().resolve(group + ".log");
  }

  // The end

  boolean isRunning() {
    return running;
  }

  void requireRunning() throws ActivationException {
    if (!running) {
      throw new ActivationException("phoenix is shutting down; ask the next one");
    }
  }

  /** Ends every process and the daemon's own threads, then closes the journal. */
  void stop(Duration timeout) {
    running = false;
    threads.stopScheduling();
    registered.groups().forEach(ManagedGroup::wake);
    // What runs may be moving; it does not wait for a process that is only being started.
    processes().forEach(process -> process.destroy(false));
    long end = System.nanoTime() + timeout.toNanos();
    launcher.awaitLaunches(timeout);
    List<ProcessIdentity> processes = processes();
    processes.forEach(process -> process.destroy(false));
    for (ProcessIdentity process : processes) {
      // The patience is for all together: ten that do not answer cost no more than one.
      process.awaitExit(Duration.ofNanos(Math.max(0, end - System.nanoTime())));
    }
    processes.forEach(process -> process.destroy(true));
    processes.forEach(process -> process.awaitExit(timeout));
    stopKeepingProcesses();
  }

  private List<ProcessIdentity> processes() {
    return registered.groups().stream().flatMap(group -> group.process().stream()).toList();
  }

  /** Ends the daemon's own threads and closes the journal; the groups' processes live on. */
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
