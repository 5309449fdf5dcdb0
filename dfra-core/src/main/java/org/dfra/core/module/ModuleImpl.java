package org.dfra.core.module;

import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.dfra.core.config.Parameters;
import org.dfra.core.event.EventHub;
import org.dfra.core.history.HistoryBook;
import org.dfra.core.history.HistoryWriter;
import org.dfra.core.lease.LeaseBook;
import org.dfra.core.log.LogLevels;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent;
import org.dfra.event.ModuleListener;
import org.dfra.event.Reading;
import org.dfra.event.Subscription;
import org.dfra.event.delivery.DeliveryPool;
import org.dfra.event.delivery.ListenerQueue;
import org.dfra.event.delivery.Tally;
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
import org.jspecify.annotations.Nullable;
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
  private final LeaseBook leases;
  private final HistoryBook history;

  /** Held while {@link #onStart} or {@link #onClose} runs; taken before {@link #lock}. */
  private final ReentrantLock lifecycle = new ReentrantLock();

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition readinessChanged = lock.newCondition();
  private Readiness readiness = Readiness.CREATED; // guarded by lock
  private boolean started; // guarded by lock
  private boolean closed; // guarded by lock
  private boolean lapsed; // guarded by lock: it served once, and has not come back since
  private int clients; // guarded by lock

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
        new EventHub(path(), clock, context.state(), DeliveryPool.shared(), context.scheduler());
    this.leases =
        new LeaseBook(path(), context.leases(), clock, context.scheduler(), this::countedClients);
    this.history =
        new HistoryBook(
            path(), context.state(), clock, context.scheduler(), HistoryWriter.shared(), log);
  }

  /**
   * Begins to work: {@link Readiness#CREATED} to {@link Readiness#INITIALIZING}. Does nothing when
   * already begun or ended. Where {@link #onStart} throws, the module is {@link Readiness#FAILED},
   * the caller gets what was thrown, and {@link #close} is still to be called.
   */
  public final void start() {
    lifecycle.lock();
    try {
      if (!begin()) {
        return;
      }
      onStart();
    } catch (RuntimeException | Error e) {
      failIfAlive("it could not be started: " + e);
      throw e;
    } finally {
      lifecycle.unlock();
    }
  }

  /**
   * Ends for good: {@link Readiness#STOPPED} at once, so that nobody waits for this module any
   * longer; then {@link #onClose}, after an {@link #onStart} that may still run. Does nothing when
   * already ended.
   */
  @Override
  public final void close() {
    if (!end()) {
      return;
    }
    leases.close();
    lifecycle.lock();
    try {
      if (wasStarted()) {
        onClose();
        history.flush();
      }
    } finally {
      lifecycle.unlock();
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

  private boolean begin() {
    lock.lock();
    try {
      if (started || closed) {
        return false;
      }
      started = true;
      history.begin();
      become(Readiness.INITIALIZING);
      return true;
    } finally {
      lock.unlock();
    }
  }

  private boolean wasStarted() {
    lock.lock();
    try {
      return started;
    } finally {
      lock.unlock();
    }
  }

  /** Whether it had not ended before. */
  private boolean end() {
    lock.lock();
    try {
      if (closed) {
        return false;
      }
      become(Readiness.STOPPED);
      closed = true;
      if (started) {
        note(Incident.Kind.DEACTIVATION, "it was closed");
      }
      return true;
    } finally {
      lock.unlock();
    }
  }

  private void failIfAlive(String why) {
    lock.lock();
    try {
      if (readiness.mayBecome(Readiness.FAILED)) {
        become(Readiness.FAILED, why);
      }
    } finally {
      lock.unlock();
    }
  }

  @Override
  public final Identification identification() {
    return identification;
  }

  @Override
  public final Readiness readiness() {
    lock.lock();
    try {
      return readiness;
    } finally {
      lock.unlock();
    }
  }

  @Override
  public final Readiness awaitReadiness(Duration patience) {
    lock.lock();
    try {
      long nanos = TimeUnit.NANOSECONDS.convert(patience); // the longest there is, if too long
      while (!readiness.serves() && !readiness.isHopeless() && nanos > 0) {
        nanos = readinessChanged.awaitNanos(nanos);
      }
      return readiness;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return readiness;
    } finally {
      lock.unlock();
    }
  }

  /**
   * Moves along an arrow of {@link Readiness}. Does nothing when already there, nor after {@link
   * #close}, of which a driver's thread may hear too late to be blamed.
   *
   * @throws IllegalStateException if there is no such arrow
   */
  protected final void become(Readiness next) {
    become(next, "it went from serving to " + next);
  }

  /**
   * The same, with the reason, as a clause; it enters the history where the module stops to serve.
   * A module that becomes {@link Readiness#READY} while it has clients becomes {@link
   * Readiness#ACTIVE} right after.
   */
  protected final void become(Readiness next, String why) {
    lock.lock();
    try {
      if (readiness == next || closed) {
        return;
      }
      if (!readiness.mayBecome(next)) {
        throw new IllegalStateException(path() + " cannot go from " + readiness + " to " + next);
      }
      Readiness last = readiness;
      log.info("{}: {} -> {}", path(), last, next);
      readiness = next;
      readinessChanged.signalAll();
      history.serving(next.serves());
      events.publish(new ModuleEvent.ReadinessChanged(last, next));
      remember(last, next, why);
      if (next == Readiness.READY && clients > 0) {
        become(Readiness.ACTIVE);
      }
    } finally {
      lock.unlock();
    }
  }

  private void remember(Readiness last, Readiness next, String why) {
    if (next == Readiness.FAILED || (last.serves() && next == Readiness.INITIALIZING)) {
      lapsed = true;
      note(Incident.Kind.FAILURE, why);
    } else if (lapsed && next.serves()) {
      lapsed = false;
      note(Incident.Kind.RECOVERY, "it serves again");
    }
  }

  private void note(Incident.Kind kind, String what) {
    events.publish(new ModuleEvent.IncidentNoted(history.note(kind, what)));
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
    lock.lock();
    try {
      clients = number;
      if (closed) {
        return;
      }
      if (number > 0 && readiness == Readiness.READY) {
        become(Readiness.ACTIVE);
      } else if (number == 0 && readiness == Readiness.ACTIVE) {
        become(Readiness.READY);
      }
    } finally {
      lock.unlock();
    }
    onClients(number);
  }

  @Override
  public final Subscription subscribe(ModuleListener listener, DeliveryPolicy policy) {
    Tally tally = new Tally(listener);
    EventHub.Entry entry = events.add(tally, policy, ListenerQueue.NEVER, () -> {});
    tally.begin(entry.numbers());
    @Nullable UUID lease;
    try {
      lease = leases.hold(holder(policy), () -> revoked(entry));
    } catch (LeaseRefusedException e) { // it has ended, and will not tell anything any more
      lease = null;
    }
    @Nullable UUID held = lease;
    return new LocalSubscription(
        tally,
        () -> held != null && leases.holds(held),
        () -> {
          events.remove(entry);
          if (held != null) {
            boolean unused = leases.cancel(held);
          }
        });
  }

  /** A listener's lease was ended for it. Of the module's own end it still hears. */
  private void revoked(EventHub.Entry entry) {
    if (readiness() != Readiness.STOPPED) {
      events.remove(entry);
    }
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
