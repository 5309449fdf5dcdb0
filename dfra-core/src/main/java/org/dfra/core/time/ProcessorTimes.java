package org.dfra.core.time;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * The processor times of a virtual machine since boot, as Linux counts them in {@code /proc/stat}.
 * If the host has too few processors for all its virtual machines, it assigns them to others
 * meanwhile; that is the <em>steal</em> time.
 *
 * @param busyTicks time for which programs ran, hundredths of a second, sum of all processors
 * @param stealTicks time for which the host prevented runnable programs from running, likewise
 */
record ProcessorTimes(long busyTicks, long stealTicks) {

  /** Unknown times. */
  static final ProcessorTimes UNKNOWN = new ProcessorTimes(0, 0);

  private static final Path FILE = Path.of("/proc/stat");

  /** Columns of the first line: user, nice, system; irq and softirq; steal. */
  private static final List<Integer> SERVED = List.of(1, 2, 3, 6, 7);

  private static final int STOLEN = 8;

  private static final long TICK_NANOS = TimeUnit.MILLISECONDS.toNanos(10);

  /** The times of this computer until now; {@link #UNKNOWN} if it does not count them. */
  static ProcessorTimes now() {
    try (var lines = Files.lines(FILE)) {
      return of(lines.findFirst().orElse(""));
    } catch (IOException | NumberFormatException e) {
      return UNKNOWN; // not Linux
    }
  }

  /**
   * Parses the line of all processors.
   *
   * @param line such as {@code cpu 1493296 0 295974 1011717 8435 0 19100 4626 0 0}
   */
  static ProcessorTimes of(String line) {
    String[] words = line.split(" +");
    if (!words[0].equals("cpu") || words.length <= STOLEN) {
      return UNKNOWN;
    }
    long[] ticks = Arrays.stream(words).skip(1).mapToLong(Long::parseLong).toArray();
    return new ProcessorTimes(
        SERVED.stream().mapToLong(column -> ticks[column - 1]).sum(), ticks[STOLEN - 1]);
  }

  /**
   * Upper estimate of the time since then for which runnable programs had no processor: the
   * fraction of the requested processor time that was stolen, applied to that time, and at most the
   * sum of the steal times of all processors.
   *
   * @param before the processor times at the begin of that time
   * @param time its duration
   */
  Duration stolenSince(ProcessorTimes before, Duration time) {
    long lost = stealTicks - before.stealTicks;
    long wanted = busyTicks - before.busyTicks + lost;
    if (lost <= 0 || wanted <= 0) {
      return Duration.ZERO;
    }
    double share = (double) lost / wanted;
    return Duration.ofNanos(Math.min((long) (time.toNanos() * share), lost * TICK_NANOS));
  }
}
