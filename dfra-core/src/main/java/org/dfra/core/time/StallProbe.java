package org.dfra.core.time;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.DoubleSupplier;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * Measures whether this computer runs its programs on time, so that a late program can be
 * distinguished from one that the computer delayed.
 *
 * <p>A separate thread sleeps for {@link #PERIOD} repeatedly. If a sleep is more than 5 ms too
 * long, the excess is a <em>stall</em>: the computer was suspended, swapped, or its host gave it no
 * processor. With the same period the thread reads the number of runnable threads of the whole
 * computer. If they are more than the processors, each program runs slower by that ratio, without
 * any stall. The same happens if the host of a virtual machine assigns processors to others in
 * slices that are too short to be seen as stalls; Linux counts these as steal time. {@link Timing}
 * defines how a missed bound is judged by all three.
 *
 * <pre>
 *   try (StallProbe probe = StallProbe.start()) {
 *     StallProbe.Stopwatch watch = probe.stopwatch();
 *     ...
 *     watch.stop().requireWithin("listening again after kill -9", Duration.ofSeconds(5));
 *   }
 * </pre>
 *
 * <p>For a span of time that is judged only after it has ended, use {@link #past}.
 *
 * <p>The thread is a daemon; {@link #start()} starts it and {@link #close()} ends it.
 */
public final class StallProbe implements AutoCloseable {

  /** The period of the measurements. */
  public static final Duration PERIOD = Duration.ofMillis(20);

  private static final long PERIOD_NANOS = PERIOD.toNanos();

  /** Normal lateness of a timer, in nanoseconds. */
  private static final long USUAL_LATENESS_NANOS = TimeUnit.MILLISECONDS.toNanos(5);

  /** Number of measurements kept for {@link #past}: {@link #MAX_LOOKBACK} at the normal period. */
  private static final int CAPACITY = 4096;

  /** The time that {@link #past} can look back at least. */
  public static final Duration MAX_LOOKBACK = PERIOD.multipliedBy(CAPACITY);

  private static final Path LOAD = Path.of("/proc/loadavg");

  private final LongSupplier nanos;
  private final DoubleSupplier load;
  private final Supplier<ProcessorTimes> processors;
  private final Thread thread = new Thread(this::run, "dfra-stall-probe");

  private volatile boolean closed;

  @GuardedBy("this")
  private long due;

  @GuardedBy("this")
  private long stalledNanos;

  @GuardedBy("this")
  private double loadSum;

  @GuardedBy("this")
  private long measurements;

  /** A ring buffer of the last {@value #CAPACITY} measurements. */
  @GuardedBy("this")
  private final long[] times = new long[CAPACITY];

  @GuardedBy("this")
  private final long[] stalls = new long[CAPACITY];

  @GuardedBy("this")
  private final double[] loads = new double[CAPACITY];

  @GuardedBy("this")
  private final ProcessorTimes[] processorTimes = new ProcessorTimes[CAPACITY];

  /** For tests: with another clock, load and processor times. */
  StallProbe(LongSupplier nanos, DoubleSupplier load, Supplier<ProcessorTimes> processors) {
    this.nanos = nanos;
    this.load = load;
    this.processors = processors;
    this.due = nanos.getAsLong() + PERIOD_NANOS;
    thread.setDaemon(true);
  }

  /** Starts a probe, which measures until it is closed. */
  public static StallProbe start() {
    StallProbe probe =
        new StallProbe(System::nanoTime, StallProbe::runnablePerProcessor, ProcessorTimes::now);
    probe.thread.start();
    return probe;
  }

  /** Starts a stopwatch. */
  public Stopwatch stopwatch() {
    return new Stopwatch();
  }

  /** Ends the measurement; stopwatches that are stopped later do not include the time after it. */
  @Override
  public void close() {
    closed = true;
    LockSupport.unpark(thread);
  }

  private void run() {
    while (!closed) {
      long wait = waitNanos();
      if (wait > 0) {
        LockSupport.parkNanos(this, wait);
      } else {
        measure();
      }
    }
  }

  private synchronized long waitNanos() {
    return due - nanos.getAsLong();
  }

  /** One measurement, at the end of a sleep. */
  synchronized void measure() {
    long now = nanos.getAsLong();
    int place = (int) (measurements % CAPACITY);
    times[place] = now;
    stalls[place] = stallAt(now);
    loads[place] = load.getAsDouble();
    processorTimes[place] = processors.get();
    stalledNanos += stalls[place];
    loadSum += loads[place];
    measurements++;
    due = now + PERIOD_NANOS;
  }

  /**
   * The measurements of a past span of time.
   *
   * @param ago how long before now it began; not longer than {@link #MAX_LOOKBACK}
   * @param took how long it lasted, not below 0; a part that is still to come counts as unmeasured
   * @throws IllegalArgumentException if it began longer ago than that, or lasted less than 0
   */
  public synchronized Timing past(Duration ago, Duration took) {
    if (ago.compareTo(MAX_LOOKBACK) > 0 || took.isNegative()) {
      throw new IllegalArgumentException(
          "a span of "
              + took
              + " that began "
              + ago
              + " ago; ask for one of at least PT0S that began at most "
              + MAX_LOOKBACK
              + " ago");
    }
    long now = nanos.getAsLong();
    long begin = now - ago.toNanos();
    long end = begin + took.toNanos();
    long stalled = closed ? 0 : overlap(begin, end, now, stallAt(now));
    double sum = 0;
    int count = 0;
    @Nullable ProcessorTimes first = null;
    ProcessorTimes last = processors.get();
    for (long i = Math.max(0, measurements - CAPACITY); i < measurements; i++) {
      int place = (int) (i % CAPACITY);
      stalled += overlap(begin, end, times[place], stalls[place]);
      if (first == null || times[place] - begin <= 0) {
        first = processorTimes[place]; // the last one before it, if there is one
      }
      if (times[place] - end <= PERIOD_NANOS) {
        last = processorTimes[place]; // the first one after it
      }
      if (times[place] - begin >= 0 && times[place] - PERIOD_NANOS - end <= 0) {
        sum += loads[place]; // also of the measurement right after a span of milliseconds
        count++;
      }
    }
    return new Timing(
        took,
        Duration.ofNanos(stalled),
        count == 0 ? 1 : sum / count,
        first == null ? Duration.ZERO : last.stolenSince(first, took));
  }

  /** How much of a stall that ended at {@code over} was between {@code begin} and {@code end}. */
  private static long overlap(long begin, long end, long over, long stall) {
    long from = Math.max(0, over - stall - begin);
    long to = Math.min(end - begin, over - begin);
    return Math.max(0, to - from);
  }

  @GuardedBy("this")
  private long stallAt(long now) {
    long late = now - due;
    return late > USUAL_LATENESS_NANOS ? late : 0;
  }

  /** Runnable threads of this computer per processor; 1 if unknown. */
  private static double runnablePerProcessor() {
    try {
      String text = Files.readString(LOAD); // 0.20 0.18 0.12 1/80 11206
      int end = text.indexOf('/');
      int begin = text.lastIndexOf(' ', end) + 1;
      double runnable = Double.parseDouble(text.substring(begin, end));
      return runnable / Runtime.getRuntime().availableProcessors();
    } catch (IOException | IndexOutOfBoundsException | NumberFormatException e) {
      return 1; // not Linux: only stalls are detected
    }
  }

  /** Measures one span of time. */
  public final class Stopwatch {

    private final long began;
    private final long stalledBefore;
    private final double loadBefore;
    private final long measurementsBefore;
    private final ProcessorTimes processorsBefore = processors.get();

    private Stopwatch() {
      synchronized (StallProbe.this) {
        began = nanos.getAsLong();
        stalledBefore = stalledNanos + (closed ? 0 : stallAt(began));
        loadBefore = loadSum;
        measurementsBefore = measurements;
      }
    }

    /** The measurement since this stopwatch was started. It continues and may be stopped again. */
    public Timing stop() {
      synchronized (StallProbe.this) {
        long now = nanos.getAsLong();
        // A stall that just ends may have woken this thread before the probe's.
        long stalled = stalledNanos + (closed ? 0 : stallAt(now)) - stalledBefore;
        long count = measurements - measurementsBefore;
        Duration took = Duration.ofNanos(now - began);
        return new Timing(
            took,
            Duration.ofNanos(Math.max(0, stalled)),
            count == 0 ? 1 : (loadSum - loadBefore) / count,
            processors.get().stolenSince(processorsBefore, took));
      }
    }
  }
}
