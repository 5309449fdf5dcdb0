package org.dfra.river.phoenix;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationInstantiator;
import java.rmi.activation.ActivationSystem;
import java.rmi.activation.Activator;
import java.rmi.activation.UnknownGroupException;
import java.rmi.activation.UnknownObjectException;
import java.rmi.server.UID;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The daemon's logic: what is registered, which processes run, who is restarted when. It knows no
 * network; the services in front of it do.
 *
 * <p>Threads: {@code phoenix-timer} (one) starts what is due later, {@code phoenix-work-n} restart
 * objects and wait for the end of processes. Both begin with {@link #recover} and end with {@link
 * #stop}.
 */
final class Daemon {

  private static final Logger LOG = LoggerFactory.getLogger(Daemon.class);

  private final PhoenixConfiguration configuration;
  private final InstantSource clock;
  private final Scheduler time;
  private final Journal journal;
  private final Map<ActivationGroupID, Group> groups = new ConcurrentHashMap<>();
  private final Map<UID, ActivatableObject> objects = new ConcurrentHashMap<>();

  private final Launcher launcher;

  private final ScheduledExecutorService timer =
      Executors.newSingleThreadScheduledExecutor(task -> thread(task, "phoenix-timer"));
  private final ExecutorService work =
      Executors.newCachedThreadPool(task -> thread(task, "phoenix-work"));
  private volatile @Nullable Activator activator;
  private volatile boolean running = true;

  /**
   * @param clock the computer's, for people
   * @param time what decides
   */
  Daemon(PhoenixConfiguration configuration, InstantSource clock, Scheduler time, Journal journal) {
    this.configuration = configuration;
    this.clock = clock;
    this.time = time;
    this.journal = journal;
    this.launcher = new Launcher(this, configuration, journal);
  }

  /**
   * Takes up what the journal says: registers everything again, takes back the processes that still
   * live, and ends those of registered groups that no journal entry knows.
   */
  void recover() {
    recovery().recover();
  }

  /**
   * Gives the groups that know phoenix at a former address an identity that names this one. Called
   * before anybody can ask for a group.
   */
  void readdress(ActivationSystem system) {
    synchronized (groups) {
      recovery().readdress(system);
    }
  }

  private Recovery recovery() {
    return new Recovery(this, journal, groups, objects);
  }

  /** Tells the daemon the activator that its IDs carry. */
  void exported(Activator itsActivator) {
    activator = itsActivator;
  }

  /** Restarts what is marked so and is not active. Called when the services are exported. */
  void open() {
    groups.values().forEach(group -> restartLater(group, Duration.ZERO));
  }

  // Registration

  ActivationGroupID registerGroup(ActivationGroupID id, ActivationGroupDesc desc)
      throws ActivationException {
    requireRunning();
    configuration.execPolicy().check(desc);
    synchronized (groups) {
      String name = journal.<String>read(r -> r.nextNumber + nameHint(desc));
      journal.commit(new Change.GroupRegistered(id, name, desc));
      groups.put(id, new Group(this, id, name, 0));
      LOG.info("Registered group {}.", name);
    }
    return id;
  }

  private static String nameHint(ActivationGroupDesc desc) {
    String hint =
        desc.getPropertyOverrides() == null
            ? null
            : desc.getPropertyOverrides().getProperty(Phoenix.GROUP_NAME);
    return hint == null ? "-group" : "-" + hint.replaceAll("[^A-Za-z0-9_.]+", ".");
  }

  ActivationGroupDesc describeGroup(ActivationGroupID id, ActivationGroupDesc desc)
      throws ActivationException {
    requireRunning();
    group(id);
    configuration.execPolicy().check(desc);
    synchronized (groups) {
      ActivationGroupDesc old = groupDesc(id);
      journal.commit(new Change.GroupDescribed(id, desc));
      return old;
    }
  }

  ActivationGroupDesc groupDesc(ActivationGroupID id) throws UnknownGroupException {
    group(id);
    return journal.read(r -> r.group(id).desc);
  }

  void unregisterGroup(ActivationGroupID id) throws ActivationException {
    requireRunning();
    synchronized (groups) {
      Group group = group(id);
      journal.commit(new Change.GroupUnregistered(id));
      groups.remove(id);
      objects.values().removeIf(object -> object.group == group);
      group.forget();
      LOG.info("Unregistered group {}.", group.name);
    }
  }

  UID registerObject(ActivationDesc desc) throws ActivationException {
    requireRunning();
    synchronized (groups) {
      Group group = group(desc.getGroupID());
      UID uid = new UID();
      journal.commit(new Change.ObjectRegistered(uid, desc));
      objects.put(uid, new ActivatableObject(uid, group, desc));
      return uid;
    }
  }

  ActivationDesc describeObject(UID uid, ActivationDesc desc) throws ActivationException {
    requireRunning();
    synchronized (groups) {
      ActivatableObject object = object(uid);
      if (!object.group.id.equals(desc.getGroupID())) {
        throw new ActivationException(
            "the new descriptor is of another group; an object stays in " + object.group.name);
      }
      ActivationDesc old = object.desc();
      journal.commit(new Change.ObjectDescribed(uid, desc));
      object.describe(desc);
      return old;
    }
  }

  void unregisterObject(UID uid) throws ActivationException {
    requireRunning();
    synchronized (groups) {
      ActivatableObject object = object(uid);
      object.retire(); // before it is asked where it may run: then nobody begins to make it
      long incarnation = object.mayBeActive() ? object.group.incarnation() : 0;
      try {
        journal.commit(new Change.ObjectUnregistered(uid, incarnation));
      } catch (ActivationException | RuntimeException e) {
        object.unretire();
        throw e;
      }
      objects.remove(uid);
      object.group.keeps(uid, incarnation);
    }
  }

  /** Unregisters an object that is not active; false, with nothing changed, if it is. */
  boolean unregisterInactive(ActivatableObject object) throws ActivationException {
    requireRunning();
    if (!object.retireUnlessActive()) {
      return false;
    }
    unregisterObject(object.uid);
    return true;
  }

  /**
   * A group's process says that an object is not active any more.
   *
   * @throws UnknownObjectException if it is not registered, or not any more
   */
  void inactive(UID uid) throws UnknownObjectException {
    ActivatableObject object = objects.get(uid);
    if (object != null) {
      object.inactive();
      return;
    }
    for (Group group : groups.values()) {
      if (group.gaveUp(uid)) {
        try {
          journal.commit(new Change.UnregisteredEnded(group.id, uid));
        } catch (ActivationException e) { // the next daemon ends a process too many
          LOG.warn("The end of an object of {} is not recorded: {}", group.name, e.getMessage());
        }
      }
    }
    throw new UnknownObjectException("phoenix has no such object registered");
  }

  /** The activation IDs of those of a group's objects that may be active. */
  List<ActivationID> activeObjects(ActivationGroupID id) throws UnknownGroupException {
    Group group = group(id);
    return objects.values().stream()
        .filter(object -> object.group == group && object.mayBeActive())
        .map(object -> activationID(object.uid))
        .toList();
  }

  Group group(ActivationGroupID id) throws UnknownGroupException {
    Group group = groups.get(id);
    if (group == null) {
      throw new UnknownGroupException("phoenix has no such group registered");
    }
    return group;
  }

  ActivatableObject object(UID uid) throws UnknownObjectException {
    ActivatableObject object = objects.get(uid);
    if (object == null) {
      throw new UnknownObjectException("phoenix has no such object registered");
    }
    return object;
  }

  /** The activation ID of a registered object. */
  ActivationID activationID(UID uid) {
    return new JeriActivationID(Objects.requireNonNull(activator, "not exported yet"), uid);
  }

  /** Every group's descriptor. */
  Map<ActivationGroupID, ActivationGroupDesc> groupDescs() {
    return journal.read(
        r -> {
          Map<ActivationGroupID, ActivationGroupDesc> descs = new java.util.LinkedHashMap<>();
          r.groups.forEach((id, record) -> descs.put(id, record.desc));
          return descs;
        });
  }

  /** The descriptors of a group's objects. */
  Map<ActivationID, ActivationDesc> objectDescs(ActivationGroupID id) throws UnknownGroupException {
    group(id);
    Map<ActivationID, ActivationDesc> descs = new java.util.LinkedHashMap<>();
    journal
        .<Map<UID, ActivationDesc>>read(r -> r.objectsOf(id))
        .forEach((uid, desc) -> descs.put(activationID(uid), desc));
    return descs;
  }

  /** What an administrator sees. */
  List<GroupStatus> status() {
    List<ActivationGroupID> order = journal.read(r -> List.copyOf(r.groups.keySet()));
    return order.stream()
        .map(groups::get)
        .filter(Objects::nonNull)
        .map(
            group ->
                group.status((int) objects.values().stream().filter(o -> o.group == group).count()))
        .toList();
  }

  // Processes

  /** Starts and counts the processes of groups. */
  Launcher launcher() {
    return launcher;
  }

  /** Has the group told when its process ends; {@code child} where this phoenix started it. */
  void watch(Group group, ProcessIdentity identity, @Nullable Process child) {
    if (child != null) {
      child
          .onExit()
          .thenAccept(ended -> group.died(identity, "ended (exit code " + ended.exitValue() + ")"));
    } else {
      work.execute(
          () -> {
            if (identity.awaitDeath(Duration.ofDays(36500))) {
              group.died(identity, "ended (exit code unknown: it was a former phoenix's child)");
            }
          });
    }
  }

  /** Ends a process that said it would end, if it has not done so in a while. */
  void endLater(ProcessIdentity process) {
    after(configuration.unexportTimeout().plusSeconds(2), () -> process.destroy(true));
  }

  /** Activates the objects of a group that are marked to be restarted, after a delay. */
  void restartLater(Group group, Duration delay) {
    List<ActivatableObject> marked =
        objects.values().stream()
            .filter(o -> o.group == group && o.desc().getRestartMode())
            .toList();
    if (marked.isEmpty()) {
      return;
    }
    LOG.info("Objects of group {} are restarted in {} ms.", group.name, delay.toMillis());
    after(delay, () -> marked.forEach(object -> work.execute(() -> restart(object, 1))));
  }

  private void restart(ActivatableObject object, int attempt) {
    if (!running || objects.get(object.uid) != object) {
      return;
    }
    try {
      object.activate(activationID(object.uid), false);
    } catch (ActivationException e) {
      boolean groupLives = object.group.process().isPresent();
      LOG.warn("Group {}: {}", object.group.name, e.getMessage());
      // Where the group itself failed, its own history decides about the next start.
      if (groupLives && attempt < configuration.restartPolicy().limit()) {
        after(
            configuration.restartPolicy().delay(attempt + 1),
            () -> work.execute(() -> restart(object, attempt + 1)));
      }
    }
  }

  /**
   * Whether the modules of a group had worked in an incarnation. Those that are marked to be
   * restarted count, each of them; where none is, those that were activated.
   */
  boolean hadWorked(Group group, long incarnation) {
    List<ActivatableObject> all =
        objects.values().stream().filter(each -> each.group == group).toList();
    List<ActivatableObject> marked =
        all.stream().filter(each -> each.desc().getRestartMode()).toList();
    List<ActivatableObject> counted =
        marked.isEmpty()
            ? all.stream().filter(each -> each.wasActive(incarnation)).toList()
            : marked;
    return !counted.isEmpty() && counted.stream().allMatch(each -> each.worked(incarnation));
  }

  /** Runs a task after a delay, on the timer's thread. */
  void after(Duration delay, Runnable task) {
    if (running) {
      timer.schedule(task, delay.toNanos(), TimeUnit.NANOSECONDS);
    }
  }

  /** An instantiator prepared as configured. */
  ActivationInstantiator prepared(ActivationInstantiator raw) throws RemoteException {
    return (ActivationInstantiator) configuration.instantiatorPreparer().prepareProxy(raw);
  }

  // The end

  /** Ends every process and the daemon's own threads, then closes the journal. */
  void stop(Duration patience) {
    running = false;
    groups.values().forEach(Group::wake);
    // What runs may be moving; it does not wait for a process that is only being started.
    processes().forEach(process -> process.destroy(false));
    long end = System.nanoTime() + patience.toNanos();
    launcher.awaitNone(patience);
    List<ProcessIdentity> processes = processes();
    processes.forEach(process -> process.destroy(false));
    for (ProcessIdentity process : processes) {
      // The patience is for all together: ten that do not answer cost no more than one.
      process.awaitDeath(Duration.ofNanos(Math.max(0, end - System.nanoTime())));
    }
    processes.forEach(process -> process.destroy(true));
    processes.forEach(process -> process.awaitDeath(patience));
    abandon();
  }

  private List<ProcessIdentity> processes() {
    return groups.values().stream().flatMap(group -> group.process().stream()).toList();
  }

  /** Ends the daemon's own threads and closes the journal; the groups' processes live on. */
  void abandon() {
    running = false;
    timer.shutdownNow();
    work.shutdownNow();
    try {
      journal.close();
    } catch (IOException e) {
      LOG.warn("The journal did not close well; every acknowledged change is safe in it.", e);
    }
  }

  boolean isRunning() {
    return running;
  }

  void requireRunning() throws ActivationException {
    if (!running) {
      throw new ActivationException("phoenix is shutting down; ask the next one");
    }
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

  /** The file with what a group's process prints. */
  Path output(String group) {
    return configuration.outputDirectory().resolve(group + ".log");
  }

  private static Thread thread(Runnable task, String name) {
    Thread thread = new Thread(task, name);
    thread.setDaemon(true);
    return thread;
  }
}
