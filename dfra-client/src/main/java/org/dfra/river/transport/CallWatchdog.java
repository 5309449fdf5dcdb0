package org.dfra.river.transport;

import java.lang.System.Logger.Level;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/**
 * Abandons calls at their deadlines, and tends the idle connections.
 *
 * <p>Thread: one daemon, {@code dfra-watchdog}, from the first call on. It wakes up at the earliest
 * deadline and, while calls are made, every {@value #TICK_MILLIS} ms: so a call usually neither
 * wakes it nor waits for it.
 */
public final class CallWatchdog {

  private static final System.Logger LOG = System.getLogger(CallWatchdog.class.getName());

  private static final long TICK_MILLIS = 250;
  private static final long TICK_NANOS = TimeUnit.MILLISECONDS.toNanos(TICK_MILLIS);

  private static final ConcurrentHashMap<CallInFlight, Deadlines> CALLS = new ConcurrentHashMap<>();

  private static final Thread THREAD = start();

  /** When the thread wakes up, as {@link System#nanoTime()}. */
  private static volatile long wakesAt = System.nanoTime();

  /** Whether a call was watched since the thread last looked. */
  private static volatile boolean wasUsed;

  private record Deadlines(long connected, long answered) {}

  private CallWatchdog() {}

  /**
   * Watches a call until {@link #release}.
   *
   * @param connectMillis the call is abandoned if it has no connection after so many milliseconds
   * @param answerMillis or no response after so many
   */
  public static void watch(CallInFlight call, long connectMillis, long answerMillis) {
    long now = System.nanoTime();
    long connected = now + TimeUnit.MILLISECONDS.toNanos(Math.min(connectMillis, answerMillis));
    CALLS.put(call, new Deadlines(connected, now + TimeUnit.MILLISECONDS.toNanos(answerMillis)));
    wakeBy(connected);
  }

  /**
   * Sees to it that the thread looks in time.
   *
   * @param time {@link System#nanoTime()} at which something is due at the latest
   */
  static void wakeBy(long time) {
    if (!wasUsed) {
      wasUsed = true;
    }
    if (time - wakesAt < 0) {
      LockSupport.unpark(THREAD);
    }
  }

  /** Ends the watch. */
  public static void release(CallInFlight call) {
    CALLS.remove(call);
  }

  private static Thread start() {
    Thread thread = new Thread(CallWatchdog::run, "dfra-watchdog");
    thread.setDaemon(true);
    thread.setContextClassLoader(null);
    thread.start();
    return thread;
  }

  private static void run() {
    while (true) {
      try {
        waitAndTend();
      } catch (RuntimeException | Error e) { // the deadlines of all other calls depend on it
        LOG.log(Level.ERROR, "The watchdog of calls failed; it goes on.", e);
      }
    }
  }

  private static void waitAndTend() {
    boolean used = wasUsed;
    wasUsed = false;
    long now = System.nanoTime();
    long rest = Math.min(abandonLate(now), ClientConnections.tendAll(now));
    if (used) {
      rest = Math.min(rest, TICK_NANOS);
    }
    if (rest == Long.MAX_VALUE) {
      rest = Long.MAX_VALUE / 2;
    }
    wakesAt = now + rest;
    // A call that was added before this line sees it, or is seen here.
    if (wasUsed) {
      return; // a connection may have become idle since
    }
    long again = System.nanoTime();
    if (earliest(again) >= wakesAt - again) {
      LockSupport.parkNanos(CallWatchdog.class, wakesAt - again);
    }
  }

  private static long earliest(long now) {
    long rest = Long.MAX_VALUE;
    for (Deadlines each : CALLS.values()) {
      rest = Math.min(rest, each.connected - now > 0 ? each.connected - now : each.answered - now);
    }
    return rest;
  }

  /** Returns how long the next call may still take, in nanoseconds. */
  private static long abandonLate(long now) {
    long rest = Long.MAX_VALUE;
    for (var entry : CALLS.entrySet()) {
      CallInFlight call = entry.getKey();
      Deadlines deadlines = entry.getValue();
      boolean isLate = deadlines.answered - now <= 0;
      if (isLate || (deadlines.connected - now <= 0 && !call.hasRequest())) {
        CALLS.remove(call);
        call.abandon();
      } else {
        rest =
            Math.min(
                rest,
                deadlines.connected - now > 0
                    ? deadlines.connected - now
                    : deadlines.answered - now);
      }
    }
    return rest;
  }
}
