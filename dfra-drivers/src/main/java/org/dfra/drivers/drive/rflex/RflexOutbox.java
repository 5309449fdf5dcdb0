package org.dfra.drivers.drive.rflex;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.EnumMap;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.dfra.drivers.drive.rflex.RflexMessage.Axis;
import org.dfra.drivers.link.Ticker;
import org.jspecify.annotations.Nullable;

/**
 * Queue of frames to the controller. It keeps only the newest velocity of each axis, so that no
 * outdated velocity is sent: a halt waits only for the frame that is being written, not for a
 * backlog of velocities.
 *
 * <p>A halt precedes all other frames and is sent {@value #HALTS} times, because it does no harm
 * and a frame may be corrupted. A velocity is sent once, after earlier frames such as the release
 * of the brake. The axes alternate, so that frequent velocities of one axis do not delay the other.
 * Frames are {@link #SPACING} apart, because the controller misses faster ones according to
 * reference drivers.
 *
 * <p>It owns one thread, the writer, so that callers never wait for a blocked link. {@link #start}
 * starts it; {@link #close} makes it send the queued frames immediately and end.
 */
final class RflexOutbox implements AutoCloseable {

  /** How many times a halt is sent: the last time within 0.06 s. */
  static final int HALTS = 3;

  /** Interval between frames. */
  static final Duration SPACING = Duration.ofMillis(10);

  /** Maximum time that {@link #close} waits for a blocked link. */
  private static final Duration LONGEST_END = Duration.ofSeconds(1);

  private static final Duration IDLE = Duration.ofMinutes(1);

  private final Ticker ticker;
  private final Consumer<byte[]> sink;
  private final Thread writer;

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed;

  @GuardedBy("lock")
  private final Map<Axis, byte[]> velocities = new EnumMap<>(Axis.class);

  @GuardedBy("lock")
  private final Queue<byte[]> others = new ArrayDeque<>();

  // the axis that is sent next
  @GuardedBy("lock")
  private Axis next = Axis.TRANSLATION;

  // frames of a halt that are still to be sent
  @GuardedBy("lock")
  private int halts;

  @GuardedBy("lock")
  private boolean closed;

  @GuardedBy("lock")
  private boolean started;

  /**
   * @param name the thread is called {@code name writer}
   * @param ticker the clock for waits
   * @param sink writes each frame; may block
   */
  RflexOutbox(String name, Ticker ticker, Consumer<byte[]> sink) {
    this.ticker = ticker;
    this.sink = sink;
    this.changed = ticker.newCondition(lock);
    this.writer = ticker.newThread(name + " writer", this::run);
  }

  /** Starts the writer; does nothing when already started or closed. */
  void start() {
    lock.lock();
    try {
      if (!started && !closed) {
        started = true;
        writer.start();
      }
    } finally {
      lock.unlock();
    }
  }

  /** Queues velocities; replaces those that are not sent yet. */
  void velocity(byte[] translation, byte[] rotation) {
    put(translation, rotation, false);
  }

  /** Queues a halt, before all other frames, to be sent more than once. */
  void halt(byte[] translation, byte[] rotation) {
    put(translation, rotation, true);
  }

  private void put(byte[] translation, byte[] rotation, boolean isHalt) {
    lock.lock();
    try {
      velocities.put(Axis.TRANSLATION, translation);
      velocities.put(Axis.ROTATION, rotation);
      halts = isHalt ? 2 * HALTS : 0;
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  /** Queues a frame after the queued ones, but before velocities. */
  void add(byte[] frame) {
    lock.lock();
    try {
      others.add(frame);
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  /** Discards the queued frames, because the controller is lost. */
  void clear() {
    lock.lock();
    try {
      velocities.clear();
      others.clear();
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void close() {
    lock.lock();
    try {
      closed = true;
      changed.signalAll();
      if (!started) {
        return;
      }
    } finally {
      lock.unlock();
    }
    try {
      boolean unused = ticker.join(writer, LONGEST_END); // otherwise closing the link unblocks it
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void run() {
    for (byte[] frame = take(); frame != null; frame = take()) {
      sink.accept(frame);
      awaitSpacing();
    }
  }

  /** Waits for the next frame; null when there will be none. */
  private byte @Nullable [] take() {
    lock.lock();
    try {
      byte[] frame = poll();
      while (frame == null && !closed) {
        ticker.await(changed, IDLE.toNanos());
        frame = poll();
      }
      return frame;
    } catch (InterruptedException e) {
      return null; // only the end of the process does that
    } finally {
      lock.unlock();
    }
  }

  @GuardedBy("lock")
  private byte @Nullable [] poll() {
    boolean isUrgent = halts > 2 * (HALTS - 1); // a halt has not been sent yet
    if (velocities.isEmpty() || (!isUrgent && !others.isEmpty())) {
      return others.poll();
    }
    Axis axis = velocities.containsKey(next) ? next : other(next);
    next = other(axis);
    halts--;
    return halts >= 2 ? velocities.get(axis) : velocities.remove(axis);
  }

  private static Axis other(Axis axis) {
    return axis == Axis.TRANSLATION ? Axis.ROTATION : Axis.TRANSLATION;
  }

  private void awaitSpacing() {
    lock.lock();
    try {
      long begin = ticker.nanos();
      long left = SPACING.toNanos();
      while (!closed && left > 0) {
        ticker.await(changed, left);
        left = SPACING.toNanos() - (ticker.nanos() - begin);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      lock.unlock();
    }
  }
}
