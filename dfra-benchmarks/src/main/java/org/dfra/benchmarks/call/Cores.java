package org.dfra.benchmarks.call;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.benchmarks.call.CallCondition.ConditionUnavailableException;

/**
 * The cores on which this process may start others.
 *
 * @param allowed their numbers, ascending
 * @param canPin whether a process can be pinned to one of them
 * @param lowestPriority the command that starts a program with the lowest priority of this
 *     computer; empty if there is none
 */
record Cores(List<Integer> allowed, boolean canPin, List<String> lowestPriority) {

  private static final Pattern ALLOWED = Pattern.compile("(?m)^Cpus_allowed_list:\\s+(\\S+)$");
  private static final Path STATUS = Path.of("/proc/self/status");

  /** Those of this computer. */
  static Cores ofThisComputer() throws IOException, InterruptedException {
    List<Integer> allowed = List.of();
    if (Files.exists(STATUS)) {
      Matcher found = ALLOWED.matcher(Files.readString(STATUS));
      allowed = found.find() ? parse(found.group(1)) : List.of();
    }
    boolean canPin = !allowed.isEmpty() && runs("taskset", "-c", allowed.get(0).toString(), "true");
    List<String> lowestPriority = List.of();
    for (List<String> each : List.of(List.of("chrt", "-i", "0"), List.of("nice", "-n", "19"))) {
      List<String> trial = new ArrayList<>(each);
      trial.add("true");
      if (lowestPriority.isEmpty() && runs(trial.toArray(String[]::new))) {
        lowestPriority = each;
      }
    }
    return new Cores(allowed, canPin, lowestPriority);
  }

  /** Numbers of a list such as {@code 0-3,8}. */
  static List<Integer> parse(String list) {
    List<Integer> numbers = new ArrayList<>();
    for (String range : list.split(",", -1)) {
      String[] ends = range.split("-", -1);
      int last = Integer.parseInt(ends[ends.length - 1]);
      for (int i = Integer.parseInt(ends[0]); i <= last; i++) {
        numbers.add(i);
      }
    }
    return List.copyOf(numbers);
  }

  private static boolean runs(String... command) throws InterruptedException {
    try {
      return new ProcessBuilder(command)
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .start()
              .waitFor()
          == 0;
    } catch (IOException e) { // there is no such program
      return false;
    }
  }

  /**
   * The first of them, to pin processes to.
   *
   * @param count how many
   * @throws ConditionUnavailableException if there are fewer, or processes cannot be pinned
   */
  List<Integer> pinned(int count) throws ConditionUnavailableException {
    if (!canPin) {
      throw new ConditionUnavailableException(
          "the command taskset, which is not here; install the package util-linux");
    }
    if (allowed.size() < count) {
      throw new ConditionUnavailableException(
          count
              + " cores, and this process may use only "
              + allowed.size()
              + "; run it on a computer with more, or without taskset");
    }
    return allowed.subList(0, count);
  }

  /**
   * What {@link #lowestPriority} is.
   *
   * @throws ConditionUnavailableException if there is none
   */
  List<String> commandOfLowestPriority() throws ConditionUnavailableException {
    if (lowestPriority.isEmpty()) {
      throw new ConditionUnavailableException(
          "the command chrt or nice, and neither is here; install util-linux or coreutils");
    }
    return lowestPriority;
  }
}
