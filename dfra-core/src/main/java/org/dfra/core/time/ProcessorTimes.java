package org.dfra.core.time;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * What a virtual computer's processors have done since it was started, as Linux counts it in {@code
 * /proc/stat}. Where the host has too few processors for all its virtual computers, it gives them
 * to others meanwhile; that is the <em>steal</em> time.
 *
 * @param busyTicks for how long programs ran, hundredths of a second, all processors together
 * @param stealTicks for how long the host kept programs from running that wanted to, likewise
 */
record ProcessorTimes(long busyTicks, long stealTicks) {

  /** Where it is not known. */
  static final ProcessorTimes UNKNOWN = new ProcessorTimes(0, 0);

  private static final Path FILE = Path.of("/proc/stat");

  /** Columns of the first line: user, nice, system; irq and softirq; steal. */
  private static final List<Integer> SERVED = List.of(1, 2, 3, 6, 7);

  private static final int STOLEN = 8;

  private static final long TICK_NANOS = TimeUnit.MILLISECONDS.toNanos(10);

  /** Those of this computer until now; {@link #UNKNOWN} where it does not count them. */
  static ProcessorTimes now() {
    try (var lines = Files.lines(FILE)) {
      return of(lines.findFirst().orElse(""));
    } catch (IOException | NumberFormatException e) {
      return UNKNOWN; // not Linux
    }
  }

  /**
   * Reads the line of all processors.
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
   * For how much of the time since then programs may have been without a processor that they
   * wanted: the same share of that time as of the processor time that they wanted, and no longer
   * than all processors together were given to others.
   *
   * @param before what was done when that time began
   * @param time how long it was
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
