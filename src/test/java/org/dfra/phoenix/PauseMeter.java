package org.dfra.phoenix;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/**
 * Notes when this machine did not let a thread run that only sleeps: what took long meanwhile says
 * nothing about DFRA. Thread: one daemon, {@code pause-meter}, until it is closed.
 */
final class PauseMeter implements AutoCloseable {

  private static final long SLEEP_NANOS = TimeUnit.MILLISECONDS.toNanos(10);

  /** Longer than any scheduler's slice on a machine that has time. */
  private static final long PAUSE_NANOS = TimeUnit.MILLISECONDS.toNanos(150);

  private record Pause(long end, long nanos) {}

  private final List<Pause> pauses = new ArrayList<>(); // guarded by itself
  private final Thread thread = new Thread(this::run, "pause-meter");
  private volatile boolean closed;

  PauseMeter() {
    thread.setDaemon(true);
    thread.start();
  }

  private void run() {
    long last = System.nanoTime();
    while (!closed) {
      LockSupport.parkNanos(this, SLEEP_NANOS);
      long now = System.nanoTime();
      if (now - last > PAUSE_NANOS) {
        synchronized (pauses) {
          pauses.add(new Pause(now, now - last));
        }
      }
      last = now;
    }
  }

  /** How long the machine paused, in all, since a time of {@link System#nanoTime}. */
  Duration since(long nanos) {
    synchronized (pauses) {
      return Duration.ofNanos(
          pauses.stream().filter(each -> each.end() - nanos > 0).mapToLong(Pause::nanos).sum());
    }
  }

  @Override
  public void close() {
    closed = true;
  }
}
