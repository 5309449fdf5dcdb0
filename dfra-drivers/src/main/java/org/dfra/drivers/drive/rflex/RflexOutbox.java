package org.dfra.drivers.drive.rflex;

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
 * Frames on their way to the controller. Of velocities only the newest waits, so that none is ever
 * sent when it is old: what a halt follows is the velocity that is just being written, not a queue
 * of those that were told faster than the line carries them.
 *
 * <p>A halt goes before everything else, and {@value #HALTS} times, since it does no harm and a
 * frame may be damaged on the way. A velocity goes once, after what was told before it, the release
 * of a brake, say. The axes take turns, so that velocities that come faster than they are sent do
 * not keep one of them back. Frames are {@link #SPACING} apart, since reference drivers found that
 * the controller misses those that come faster.
 *
 * <p>Owns one thread, the writer, so that whoever commands never waits for a line that is stuck.
 * {@link #start} starts it; {@link #close} has it send what waits, at once, and end.
 */
final class RflexOutbox implements AutoCloseable {

  /** How often a halt is sent: the last within 0.06 s. */
  static final int HALTS = 3;

  /** From one frame to the next. */
  static final Duration SPACING = Duration.ofMillis(10);

  /** The longest that {@link #close} waits for a line that does not take what is left. */
  private static final Duration LONGEST_END = Duration.ofSeconds(1);

  private static final Duration IDLE = Duration.ofMinutes(1);

  private final Ticker ticker;
  private final Consumer<byte[]> sink;
  private final Thread writer;

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed;
  // guarded by lock
  private final Map<Axis, byte[]> velocities = new EnumMap<>(Axis.class);
  private final Queue<byte[]> others = new ArrayDeque<>();
  private Axis next = Axis.TRANSLATION; // whose turn it is
  private int halts; // frames of a halt that are still to be sent
  private boolean closed;
  private boolean started;

  /**
   * @param name the thread is called {@code name writer}
   * @param ticker the time to wait by
   * @param sink takes each frame; may block
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

  /** Takes the place of velocities that wait. */
  void velocity(byte[] translation, byte[] rotation) {
    put(translation, rotation, false);
  }

  /** The same, before everything else, and more than once. */
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

  /** Goes after what waits, but for velocities. */
  void add(byte[] frame) {
    lock.lock();
    try {
      others.add(frame);
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  /** Forgets what waits: there is no controller to be told. */
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
      boolean unused = ticker.join(writer, LONGEST_END); // else the closing link frees it
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
      return null; // nobody but the end of the process does that
    } finally {
      lock.unlock();
    }
  }

  private byte @Nullable [] poll() {
    boolean isUrgent = halts > 2 * (HALTS - 1); // a halt was not sent yet
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
