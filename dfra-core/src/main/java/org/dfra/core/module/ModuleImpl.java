package org.dfra.core.module;

import java.time.Duration;
import java.time.InstantSource;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.dfra.core.config.Parameters;
import org.dfra.module.Identification;
import org.dfra.module.Module;
import org.dfra.module.Readiness;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Base of every driver: the last of the five classes. It talks to hardware and knows no network.
 *
 * <p>Lifecycle: the constructor assigns; {@link #start} opens the device or begins to, and returns
 * at once; {@link #close} undoes it. A device that is not there is no exception: the module stays
 * {@link Readiness#INITIALIZING} and goes on trying. {@link #start} and {@link #close} may be
 * called by any threads at any time; {@link #onStart} and {@link #onClose} never overlap.
 */
public abstract class ModuleImpl implements Module, AutoCloseable {

  protected final Logger log;

  private final Identification identification;
  private final Parameters parameters;
  private final InstantSource clock;

  /** Held while {@link #onStart} or {@link #onClose} runs; taken before {@link #lock}. */
  private final ReentrantLock lifecycle = new ReentrantLock();

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition readinessChanged = lock.newCondition();
  private Readiness readiness = Readiness.CREATED; // guarded by lock
  private boolean started; // guarded by lock
  private boolean closed; // guarded by lock

  /**
   * @param context what the driver is given
   * @param description what the driver is, for people
   * @param author who wrote it
   * @param version its version
   */
  protected ModuleImpl(ModuleContext context, String description, String author, String version) {
    this.identification =
        new Identification(context.robot(), context.name(), description, author, version);
    this.parameters = context.parameters();
    this.clock = context.clock();
    this.log = LoggerFactory.getLogger("dfra." + context.robot() + "." + context.name());
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
      failIfAlive();
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
    lifecycle.lock();
    try {
      onClose();
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

  private boolean begin() {
    lock.lock();
    try {
      if (started || closed) {
        return false;
      }
      started = true;
      become(Readiness.INITIALIZING);
      return true;
    } finally {
      lock.unlock();
    }
  }

  /** Whether there is anything to undo. */
  private boolean end() {
    lock.lock();
    try {
      if (closed) {
        return false;
      }
      become(Readiness.STOPPED);
      closed = true;
      return started;
    } finally {
      lock.unlock();
    }
  }

  private void failIfAlive() {
    lock.lock();
    try {
      if (readiness.mayBecome(Readiness.FAILED)) {
        become(Readiness.FAILED);
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
    lock.lock();
    try {
      if (readiness == next || closed) {
        return;
      }
      if (!readiness.mayBecome(next)) {
        throw new IllegalStateException(
            identification.path() + " cannot go from " + readiness + " to " + next);
      }
      log.info("{}: {} -> {}", identification.path(), readiness, next);
      readiness = next;
      readinessChanged.signalAll();
    } finally {
      lock.unlock();
    }
  }

  /** What the robot's XML and the module's properties say of this module. */
  protected final Parameters parameters() {
    return parameters;
  }

  /** The time; simulated time where the robot is simulated. */
  protected final InstantSource clock() {
    return clock;
  }

  /** {@code robot/name (driver class)}. */
  @Override
  public final String toString() {
    return identification.path() + " (" + getClass().getSimpleName() + ")";
  }
}
