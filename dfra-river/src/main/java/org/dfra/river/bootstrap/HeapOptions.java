package org.dfra.river.bootstrap;

import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The initial heap of a robot's processes. By itself, a Java virtual machine takes a share of the
 * computer's memory before it collects anything for the first time: on a computer with 16 GB, the
 * young generation alone has 85 MB, and a process that lives for long has used all of it.
 */
final class HeapOptions {

  /** Enough for what a group creates between two collections, and for the objects that stay. */
  private static final List<String> SMALL = List.of("-Xms24m", "-Xmn8m");

  private static final long INITIAL = 24L << 20;

  /** Options of a group that wants a heap of another shape. */
  private static final Pattern OWN =
      Pattern.compile(
          "-Xm[sn].*|-XX:(InitialRAMPercentage|MaxRAMPercentage|InitialHeapSize|MaxHeapSize"
              + "|NewSize|MaxNewSize|NewRatio)=.*|-XX:\\+Use(?!Serial)\\w+GC|-XX:\\+AlwaysPreTouch");

  private static final Pattern LIMIT = Pattern.compile("-Xmx(\\d{1,9})([kKmMgGtT]?)");

  private HeapOptions() {}

  /**
   * The options to put before a group's own; none if those shape the heap themselves or limit it to
   * less than 24 MB.
   *
   * @param own the options in the robot's XML
   */
  static List<String> of(List<String> own) {
    return own.stream().anyMatch(each -> OWN.matcher(each).matches() || isLow(each))
        ? List.of()
        : SMALL;
  }

  private static boolean isLow(String option) {
    Matcher limit = LIMIT.matcher(option);
    if (!limit.matches()) {
      return option.startsWith("-Xmx"); // the virtual machine will say what is wrong with it
    }
    int shift = 10 * "bkmgt".indexOf((limit.group(2) + "b").toLowerCase(Locale.ROOT).charAt(0));
    return Long.parseLong(limit.group(1)) << shift < INITIAL;
  }
}
