package org.dfra.core.module;

import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.ReentrantLock;
import org.dfra.core.config.Parameters;
import org.dfra.core.event.EventHub;
import org.dfra.core.history.HistoryBook;
import org.dfra.core.history.HistoryWriter;
import org.dfra.core.lease.LeaseBook;
import org.dfra.core.log.LogLevels;
import org.dfra.core.time.SerialExecutor;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent;
import org.dfra.event.ModuleListener;
import org.dfra.event.Reading;
import org.dfra.event.Subscription;
import org.dfra.event.delivery.DeliveryPool;
import org.dfra.lease.Holder;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.ModuleLease;
import org.dfra.module.History;
import org.dfra.module.Identification;
import org.dfra.module.Incident;
import org.dfra.module.LogLevel;
import org.dfra.module.Module;
import org.dfra.module.Parameter;
import org.dfra.module.Readiness;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Base of every driver: the last of the five classes. It talks to hardware and knows no network.
 *
 * <p>A driver says what it has to say by {@link #become}, {@link #tell} and {@link #survived};
 * events, history and the way to its listeners follow from that. It declares its parameters in
 * {@link #declared}, and learns by {@link #onClients} whether anybody wants it to work.
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
  private final HistoryBook history;
  private final Lifecycle lifecycle;
  private final SerialExecutor expiries;
  private final SerialExecutor halts;
  private final LeaseBook leases;
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
            DeliveryPool.by(context.scheduler()),
            context.scheduler());
    this.history =
        new HistoryBook(
            path(), context.state(), clock, context.scheduler(), HistoryWriter.shared(), log);
    this.lifecycle = new Lifecycle(path(), log, events, history, context.scheduler());
    this.expiries = new SerialExecutor("dfra-leases " + path(), context.scheduler());
    this.halts = new SerialExecutor("dfra-halts " + path(), context.scheduler());
    this.leases =
        new LeaseBook(
            path(),
            context.leases(),
            clock,
            context.scheduler(),
            this::countedClients,
            holder -> holder == Holder.COMMANDER ? halts : expiries);
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
  protected void onClients(int number) {}

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
  public final Optional<String> unreadiness() {
    Readiness now = readiness();
    if (now.serves()) {
      return Optional.empty();
    }
    Optional<String> awaited =
        now == Readiness.INITIALIZING
            ? readings.stream().map(LatestReading::awaits).findFirst()
            : Optional.empty();
    return awaited.or(lifecycle::why).or(() -> Optional.of(usual(now)));
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
  final void awaits(LatestReading<?> reading) {
    readings.add(reading);
  }

  /**
   * Moves along an arrow of {@link Readiness}. Does nothing when already there, nor after {@link
   * #close}, of which a driver's thread may hear too late to be blamed.
   *
   * @throws IllegalStateException if there is no such arrow
   */
  protected final void become(Readiness next) {
    lifecycle.become(next);
  }

  /**
   * The same, with the reason, as a clause; it enters the history where the module stops to serve.
   * A module that becomes {@link Readiness#READY} while it has clients becomes {@link
   * Readiness#ACTIVE} right after.
   */
  protected final void become(Readiness next, String why) {
    lifecycle.become(next, why);
  }

  /** Something has happened that enters the history, and that listeners hear of. */
  protected final void note(Incident.Kind kind, String what) {
    lifecycle.note(kind, what);
  }

  /** The driver has caught something and goes on; it enters the history. */
  protected final void survived(Throwable thrown) {
    note(Incident.Kind.EXCEPTION, thrown.toString());
  }

  /** There is a new reading. */
  protected final void tell(Reading reading) {
    events.publish(new ModuleEvent.NewReading(reading));
  }

  private void countedClients(int number) {
    lifecycle.clients(number);
    onClients(number);
  }

  @Override
  public final Subscription subscribe(ModuleListener listener, DeliveryPolicy policy) {
    return listeners.add(listener, policy);
  }

  /** Who listens to readings is a client; who listens to anything else only watches. */
  public static Holder holder(DeliveryPolicy policy) {
    return policy.kinds().contains(DeliveryPolicy.Kind.READING) ? Holder.CLIENT : Holder.WATCHER;
  }

  @Override
  public final ModuleLease use(Duration duration) throws LeaseRefusedException {
    leases.terms().check(path(), duration);
    return new LocalLease(leases, leases.hold(Holder.CLIENT, () -> {}), duration, clock);
  }

  @Override
  public final History history() {
    return history.history();
  }

  @Override
  public final LogLevel logLevel() {
    return LogLevels.service().level(log.getName());
  }

  @Override
  public final void setLogLevel(LogLevel level) {
    LogLevels.service().set(log.getName(), level);
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
  protected final SerialExecutor halts() {
    return halts;
  }

  /** Where the driver declares its parameters. */
  protected final ParameterTable declared() {
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
  public final LeaseBook leases() {
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
