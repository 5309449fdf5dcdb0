package org.dfra.core.module;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.ReentrantLock;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.RenamedNames;
import org.dfra.core.event.EventHub;
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
import org.dfra.lifecycle.Incident;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Identification;
import org.dfra.module.LogLevel;
import org.dfra.module.Module;
import org.dfra.module.ModuleHistory;
import org.dfra.module.Parameter;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Base of every driver: the last of the five classes. It communicates with hardware and is
 * independent of the network.
 *
 * <p>A driver reports by {@link #transitionTo}, {@link #publish} and {@link #recordException}; this
 * class handles events, history and listeners. A driver declares its parameters in {@link
 * #parameterTable}, and {@link #onClientCount} reports whether it has clients.
 *
 * <p>Lifecycle: the constructor only assigns fields; {@link #start} opens the device or begins to,
 * and returns at once; {@link #close} undoes it. A missing device is not an exception: the module
 * stays {@link Readiness#INITIALIZING} and keeps trying. {@link #start} and {@link #close} may be
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
   * @param context the driver's environment
   * @param description what the driver is, for display
   * @param author its author
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
   * Starts the module: {@link Readiness#CREATED} to {@link Readiness#INITIALIZING}. Does nothing
   * when already started or ended. If {@link #onStart} throws, the module becomes {@link
   * Readiness#FAILED}, the exception is passed to the caller, and {@link #close} must still be
   * called.
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
   * Ends the module: {@link Readiness#STOPPED} at once, so that no caller waits for it any longer;
   * then {@link #onClose}, after an {@link #onStart} that may still run. Does nothing when already
   * ended.
   */
  @Override
  public final void close() {
    if (!lifecycle.end()) {
      return;
    }
    try {
      endLeases();
    } finally { // the device is closed even if a lease callback failed
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
   * Opens the device or starts the thread that does. Called at most once, on the caller's thread.
   */
  protected abstract void onStart();

  /**
   * Undoes {@link #onStart} completely before it returns, also after a partial start that threw.
   * Called at most once, and only after {@link #onStart}.
   */
  protected abstract void onClose();

  /**
   * Called when the number of clients has changed. A driver may idle while there are none. Called
   * in order, by any thread, also before {@link #onStart}; must not block.
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

  /** Adds a reading that must arrive before the module serves. */
  final void addRequiredReading(LatestReading<?> reading) {
    readings.add(reading);
  }

  /**
   * Makes a transition of {@link Readiness}. Does nothing when already in that state, nor after
   * {@link #close}, since a driver's thread may notice the close late.
   *
   * @throws IllegalStateException if there is no such transition
   */
  protected final void transitionTo(Readiness next) {
    lifecycle.transitionTo(next);
  }

  /**
   * The same, with the reason, as a clause; it is recorded in the history if the module stops
   * serving. A module that becomes {@link Readiness#READY} while it has clients becomes {@link
   * Readiness#ACTIVE} right after.
   */
  protected final void transitionTo(Readiness next, String why) {
    lifecycle.transitionTo(next, why);
  }

  /** Records an incident in the history, and notifies the listeners. */
  protected final void recordIncident(Incident.Kind kind, String what) {
    lifecycle.recordIncident(kind, what);
  }

  /** Records in the history an exception that the driver has caught and handled. */
  protected final void recordException(Throwable thrown) {
    recordIncident(Incident.Kind.EXCEPTION, thrown.toString());
  }

  /** Publishes a new reading. */
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

  /** The role of a listener: a client if it receives readings, else an observer. */
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
    String present = RenamedNames.resolve(path(), "the parameter", name, declared.names());
    String now =
        declared.set(
            present, RenamedNames.resolveValue(getClass().getName(), path(), present, text));
    log.info("{}: parameter {} is now {}", path(), present, now);
    events.publish(new ModuleEvent.ParameterChanged(present, now));
  }

  /**
   * Runs tasks that stop a motion, such as a command timeout or the expiry of a commander's lease,
   * on a dedicated thread of this module.
   */
  protected final SerialExecutor haltExecutor() {
    return halts;
  }

  /** The table in which the driver declares its parameters. */
  protected final ParameterTable parameterTable() {
    return declared;
  }

  /** The module's parameters in the robot's XML and its properties. */
  protected final Parameters settings() {
    return settings;
  }

  /** The clock; a simulated clock if the robot is simulated. */
  protected final InstantSource clock() {
    return clock;
  }

  /** Its listeners, for the server that exports it. */
  public final EventHub events() {
    return events;
  }

  /** Its leases, for the server that exports it. */
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

  /**
   * The lease of a client in the module's own virtual machine. Both end together, so no renewal is
   * needed: it is valid until it is closed or the module ends.
   */
  private static final class LocalLease implements ModuleLease {

    private final LeaseRegistry book;
    private final UUID id;
    private final Duration duration;
    private final InstantSource clock;

    LocalLease(LeaseRegistry book, UUID id, Duration duration, InstantSource clock) {
      this.book = book;
      this.id = id;
      this.duration = duration;
      this.clock = clock;
    }

    @Override
    public Instant expiration() {
      return clock.instant().plus(duration);
    }

    @Override
    public boolean isLive() {
      return book.contains(id);
    }

    @Override
    public void close() {
      boolean unused = book.cancel(id);
    }
  }
}
