package org.dfra.core.module;

import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.ReentrantLock;
import org.dfra.core.config.Parameters;
import org.dfra.core.event.EventHub;
import org.dfra.core.history.HistoryExecutor;
import org.dfra.core.history.IncidentLog;
import org.dfra.core.lease.LeaseRegistry;
import org.dfra.core.log.LogLevelControl;
import org.dfra.core.time.SerialExecutor;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent;
import org.dfra.event.ModuleListener;
import org.dfra.event.Reading;
import org.dfra.event.Subscription;
import org.dfra.event.delivery.DeliveryPool;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.LeaseRole;
import org.dfra.lease.ModuleLease;
import org.dfra.module.Identification;
import org.dfra.module.Incident;
import org.dfra.module.LogLevel;
import org.dfra.module.Module;
import org.dfra.module.ModuleHistory;
import org.dfra.module.Parameter;
import org.dfra.module.Readiness;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Base of every driver: the last of the five classes. It talks to hardware and knows no network.
 *
 * <p>A driver says what it has to say by {@link #transitionTo}, {@link #publish} and {@link
 * #recordException}; events, history and the way to its listeners follow from that. It declares its
 * parameters in {@link #declared}, and learns by {@link #onClientCount} whether anybody wants it to
 * work.
 *
 * <p>Lifecycle: the constructor assigns; {@link #start} opens the device or begins to, and returns
 * at once; {@link #close} undoes it. A device that is not there is no exception: the module stays
 * {@link Readiness#INITIALIZING} and goes on trying. {@link #start} and {@link #close} may be
 * called by any threads at any time; {@link #onStart} and {@link #onClose} never overlap.
 */
public abstract class ModuleImpl implements Module, AutoCloseable {

  protected final Logger log;

  private final Identification identification;
  private final Parameters settings;
  private final InstantSource clock;
  private final ParameterTable declared;
  private final EventHub events;
  private final IncidentLog history;
  private final Lifecycle lifecycle;
  private final SerialExecutor expiries;
  private final SerialExecutor halts;
  private final LeaseRegistry leases;
  private final LocalListeners listeners;
  private final List<LatestReading<?>> readings = new CopyOnWriteArrayList<>();

  /**
   * Held while {@link #onStart} or {@link #onClose} runs; taken before {@link #lifecycle}'s own.
   */
  private final ReentrantLock transition = new ReentrantLock();

  /**
   * @param context what the driver is given
   * @param description what the driver is, for people
   * @param author who wrote it
   * @param version its version
   */
  protected ModuleImpl(ModuleContext context, String description, String author, String version) {
    this.identification =
        new Identification(context.robot(), context.name(), description, author, version);
    this.settings = context.parameters();
    this.clock = context.clock();
    this.log = LoggerFactory.getLogger("dfra." + context.robot() + "." + context.name());
    this.declared = new ParameterTable(path(), settings);
    this.events =
        new EventHub(
            path(),
            clock,
            context.state(),
            DeliveryPool.forScheduler(context.scheduler()),
            context.scheduler());
    this.history =
        new IncidentLog(
            path(), context.state(), clock, context.scheduler(), HistoryExecutor.shared(), log);
    this.lifecycle = new Lifecycle(path(), log, events, history, context.scheduler());
    this.expiries = new SerialExecutor("dfra-leases " + path(), context.scheduler());
    this.halts = new SerialExecutor("dfra-halts " + path(), context.scheduler());
    this.leases =
        new LeaseRegistry(
            path(),
            context.leases(),
            clock,
            context.scheduler(),
            this::countedClients,
            holder -> holder == LeaseRole.COMMANDER ? halts : expiries);
    this.listeners = new LocalListeners(events, leases, lifecycle);
  }

  /**
   * Begins to work: {@link Readiness#CREATED} to {@link Readiness#INITIALIZING}. Does nothing when
   * already begun or ended. Where {@link #onStart} throws, the module is {@link Readiness#FAILED},
   * the caller gets what was thrown, and {@link #close} is still to be called.
   */
  public final void start() {
    transition.lock();
    try {
      if (!lifecycle.begin()) {
        return;
      }
      onStart();
    } catch (RuntimeException | Error e) {
      lifecycle.failIfAlive("it could not be started: " + e);
      throw e;
    } finally {
      transition.unlock();
    }
  }

  /**
   * Ends for good: {@link Readiness#STOPPED} at once, so that nobody waits for this module any
   * longer; then {@link #onClose}, after an {@link #onStart} that may still run. Does nothing when
   * already ended.
   */
  @Override
  public final void close() {
    if (!lifecycle.end()) {
      return;
    }
    try {
      endLeases();
    } finally { // the device is closed even where a holder's end went wrong
      try {
        closeDevice();
      } finally {
        expiries.close();
        halts.close();
      }
    }
  }

  /** Ends every lease, before the device is closed. Must not wait for the driver. */
  protected void endLeases() {
    leases.close();
  }

  private void closeDevice() {
    transition.lock();
    try {
      if (lifecycle.wasStarted()) {
        onClose();
        history.flush();
      }
    } finally {
      transition.unlock();
    }
  }

  /**
   * Opens the device or spawns the thread that does. Called at most once, on the caller's thread.
   */
  protected abstract void onStart();

  /**
   * Undoes {@link #onStart}, completely, before it returns; also one that threw halfway. Called at
   * most once, and only after {@link #onStart}.
   */
  protected abstract void onClose();

  /**
   * The number of clients has changed: the first has come, the last has gone, or so. A driver may
   * rest while there are none. Called in order, by any thread, also before {@link #onStart}; must
   * not block.
   */
  protected void onClientCount(int number) {}

  @Override
  public final Identification identification() {
    return identification;
  }

  @Override
  public final Readiness readiness() {
    return lifecycle.readiness();
  }

  @Override
  public final Readiness awaitReadiness(Duration patience) {
    return lifecycle.await(patience);
  }

  /**
   * Why the module does not serve now, as the rest of a sentence: what failed, or what it waits
   * for. Empty while it serves.
   */
  public final Optional<String> notReadyReason() {
    Readiness now = readiness();
    if (now.serves()) {
      return Optional.empty();
    }
    Optional<String> awaited =
        now == Readiness.INITIALIZING
            ? readings.stream().map(LatestReading::missing).findFirst()
            : Optional.empty();
    return awaited.or(lifecycle::reason).or(() -> Optional.of(usual(now)));
  }

  private static String usual(Readiness state) {
    return switch (state) {
      case CREATED -> "it has not been started";
      case INITIALIZING -> "its first data have not come yet";
      case PAUSED -> "it is paused until it is resumed";
      case FAILED -> "it has failed; its log says why";
      default -> "it has ended";
    };
  }

  /** A reading that has to come before the module serves. */
  final void addRequiredReading(LatestReading<?> reading) {
    readings.add(reading);
  }

  /**
   * Moves along an arrow of {@link Readiness}. Does nothing when already there, nor after {@link
   * #close}, of which a driver's thread may hear too late to be blamed.
   *
   * @throws IllegalStateException if there is no such arrow
   */
  protected final void transitionTo(Readiness next) {
    lifecycle.transitionTo(next);
  }

  /**
   * The same, with the reason, as a clause; it enters the history where the module stops to serve.
   * A module that becomes {@link Readiness#READY} while it has clients becomes {@link
   * Readiness#ACTIVE} right after.
   */
  protected final void transitionTo(Readiness next, String why) {
    lifecycle.transitionTo(next, why);
  }

  /** Something has happened that enters the history, and that listeners hear of. */
  protected final void recordIncident(Incident.Kind kind, String what) {
    lifecycle.recordIncident(kind, what);
  }

  /** The driver has caught something and goes on; it enters the history. */
  protected final void recordException(Throwable thrown) {
    recordIncident(Incident.Kind.EXCEPTION, thrown.toString());
  }

  /** There is a new reading. */
  protected final void publish(Reading reading) {
    events.publish(new ModuleEvent.NewReading(reading));
  }

  private void countedClients(int number) {
    lifecycle.setClientCount(number);
    onClientCount(number);
  }

  @Override
  public final Subscription subscribe(ModuleListener listener, DeliveryPolicy policy) {
    return listeners.add(listener, policy);
  }

  /** Who listens to readings is a client; who listens to anything else only watches. */
  public static LeaseRole leaseRole(DeliveryPolicy policy) {
    return policy.kinds().contains(DeliveryPolicy.EventKind.READING)
        ? LeaseRole.CLIENT
        : LeaseRole.OBSERVER;
  }

  @Override
  public final ModuleLease acquireLease(Duration duration) throws LeaseRefusedException {
    leases.terms().check(path(), duration);
    return new LocalLease(leases, leases.grantLocal(LeaseRole.CLIENT, () -> {}), duration, clock);
  }

  @Override
  public final ModuleHistory history() {
    return history.history();
  }

  @Override
  public final LogLevel logLevel() {
    return LogLevelControl.service().level(log.getName());
  }

  @Override
  public final void setLogLevel(LogLevel level) {
    LogLevelControl.service().set(log.getName(), level);
  }

  @Override
  public final List<Parameter> parameters() {
    return declared.list();
  }

  @Override
  public final void setParameter(String name, String text) {
    String now = declared.set(name, text);
    log.info("{}: parameter {} is now {}", path(), name, now);
    events.publish(new ModuleEvent.ParameterChanged(name, now));
  }

  /**
   * Runs what ends a motion, such as a command that was not followed by another, or a commander's
   * lease that was not renewed, on a thread of this module's own, which does nothing else.
   */
  protected final SerialExecutor haltExecutor() {
    return halts;
  }

  /** Where the driver declares its parameters. */
  protected final ParameterTable parameterTable() {
    return declared;
  }

  /** What the robot's XML and the module's properties say of this module. */
  protected final Parameters settings() {
    return settings;
  }

  /** The time; simulated time where the robot is simulated. */
  protected final InstantSource clock() {
    return clock;
  }

  /** Its listeners, for whoever serves it to the network. */
  public final EventHub events() {
    return events;
  }

  /** Its clients, for whoever serves it to the network. */
  public final LeaseRegistry leases() {
    return leases;
  }

  /** {@code robot/name}. */
  protected final String path() {
    return identification.path();
  }

  /** {@code robot/name (driver class)}. */
  @Override
  public final String toString() {
    return path() + " (" + getClass().getSimpleName() + ")";
  }
}
