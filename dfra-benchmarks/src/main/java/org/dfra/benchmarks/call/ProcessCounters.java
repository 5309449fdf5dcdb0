package org.dfra.benchmarks.call;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Collections;
import java.util.HashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.benchmarks.attack.ProcessSample;

/**
 * The kernel's counters of a process at one time (Linux).
 *
 * @param switches voluntary context switches of each of its threads since that thread's start, by
 *     thread ID
 * @param cpu CPU time of the process since its start, also of ended threads; in steps of the
 *     kernel's clock tick, 10 ms on most computers
 */
record ProcessCounters(Map<Long, Long> switches, Duration cpu) {

  private static final Pattern VOLUNTARY =
      Pattern.compile("(?m)^voluntary_ctxt_switches:\\s+(\\d+)$");

  ProcessCounters {
    switches = Collections.unmodifiableMap(new HashMap<>(switches));
  }

  /** Whether this computer has these counters. */
  static boolean arePossible() throws IOException {
    Path status = Path.of("/proc/self/status");
    return Files.exists(status) && VOLUNTARY.matcher(Files.readString(status)).find();
  }

  /**
   * Reads them. Without {@code /proc}, there are no switches.
   *
   * @throws IOException if there is no such process
   */
  static ProcessCounters of(long pid) throws IOException {
    Map<Long, Long> switches = new HashMap<>();
    Path tasks = Path.of("/proc", Long.toString(pid), "task");
    if (Files.exists(tasks)) {
      try (DirectoryStream<Path> each = Files.newDirectoryStream(tasks)) {
        for (Path task : each) {
          readSwitches(task, switches);
        }
      }
    }
    return new ProcessCounters(switches, ProcessSample.cpu(pid));
  }

  private static void readSwitches(Path task, Map<Long, Long> switches) throws IOException {
    try {
      Matcher found = VOLUNTARY.matcher(Files.readString(task.resolve("status")));
      if (found.find()) {
        switches.put(Long.parseLong(task.getFileName().toString()), Long.parseLong(found.group(1)));
      }
    } catch (NoSuchFileException e) {
      // the thread has ended since: EndedThreads counts it
    } catch (IOException e) {
      if (Files.exists(task)) { // else likewise: "no such process"
        throw e;
      }
    }
  }

  /**
   * The voluntary context switches since an earlier time, of the threads that still live. What
   * ended threads did is not counted.
   */
  long switchesSince(ProcessCounters earlier) {
    long sum = 0;
    for (Map.Entry<Long, Long> each : switches.entrySet()) {
      sum += each.getValue() - earlier.switches.getOrDefault(each.getKey(), 0L);
    }
    return sum;
  }

  /** How many threads of the earlier time have ended. */
  long endedSince(ProcessCounters earlier) {
    return earlier.switches.keySet().stream().filter(each -> !switches.containsKey(each)).count();
  }

  /** CPU time since an earlier time, microseconds. */
  double cpuMicrosSince(ProcessCounters earlier) {
    return cpu.minus(earlier.cpu).toNanos() / 1e3;
  }
}
