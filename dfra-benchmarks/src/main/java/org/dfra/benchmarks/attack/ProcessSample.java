package org.dfra.benchmarks.attack;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The resource use of a JVM at one time.
 *
 * @param threads its threads, including those of the JVM itself
 * @param cpu its CPU time since it started, user and system
 * @param heapBytes bytes of live objects after a full collection
 */
public record ProcessSample(int threads, Duration cpu, long heapBytes) {

  private static final Pattern THREADS = Pattern.compile("(?m)^Threads:\\s+(\\d+)$");
  private static final Pattern THREAD = Pattern.compile("(?m)^\".*$");
  private static final Pattern TOTAL = Pattern.compile("(?m)^Total\\s+\\d+\\s+(\\d+)\\s*$");

  /**
   * Takes a sample. The JVM performs a full garbage collection; threads and CPU time are read
   * before.
   *
   * @param pid the process
   * @throws IOException if it is not a JVM of this user, has ended, or this Java has no {@code
   *     jcmd}
   */
  public static ProcessSample of(long pid) throws IOException, InterruptedException {
    int threads = threads(pid);
    Duration cpu = cpu(pid);
    return new ProcessSample(threads, cpu, heapBytes(pid));
  }

  /**
   * Takes a sample of each process and adds them.
   *
   * @param pids JVMs, as for {@link #of(long)}
   * @throws IOException as for {@link #of(long)}
   */
  public static ProcessSample of(List<Long> pids) throws IOException, InterruptedException {
    ProcessSample sum = new ProcessSample(0, Duration.ZERO, 0);
    for (long each : pids) {
      ProcessSample more = of(each);
      sum =
          new ProcessSample(
              sum.threads + more.threads, sum.cpu.plus(more.cpu), sum.heapBytes + more.heapBytes);
    }
    return sum;
  }

  /** Current number of threads of a process. */
  public static int threads(long pid) throws IOException, InterruptedException {
    Path status = Path.of("/proc", Long.toString(pid), "status");
    if (!Files.exists(Path.of("/proc/self/status"))) { // not Linux
      return Math.toIntExact(THREAD.matcher(jcmd(pid, "Thread.print")).results().count());
    }
    Matcher matcher = THREADS.matcher(Files.readString(status));
    if (!matcher.find()) {
      throw new IOException(status + " has no line with the number of threads");
    }
    return Integer.parseInt(matcher.group(1));
  }

  /** CPU time of a process since it started. */
  public static Duration cpu(long pid) throws IOException {
    return ProcessHandle.of(pid)
        .flatMap(process -> process.info().totalCpuDuration())
        .orElseThrow(() -> new IOException("process " + pid + " has ended, or is another user's"));
  }

  /** Total CPU time of several processes since they started. */
  public static Duration cpu(List<Long> pids) throws IOException {
    Duration sum = Duration.ZERO;
    for (long each : pids) {
      sum = sum.plus(cpu(each));
    }
    return sum;
  }

  /** Bytes of a JVM's live objects after a full collection. */
  public static long heapBytes(long pid) throws IOException, InterruptedException {
    String histogram = jcmd(pid, "GC.class_histogram");
    Matcher matcher = TOTAL.matcher(histogram);
    if (!matcher.find()) {
      throw new IOException("jcmd " + pid + " GC.class_histogram says no total: " + histogram);
    }
    return Long.parseLong(matcher.group(1));
  }

  /**
   * Runs a command in a JVM. The output goes through a file, not a pipe: from JDK 24 on a JVM
   * writes it while its threads are stopped, so none of them could read the pipe if it is this JVM.
   */
  private static String jcmd(long pid, String command) throws IOException, InterruptedException {
    Path jcmd = Path.of(System.getProperty("java.home"), "bin", "jcmd");
    Path output = Files.createTempFile("dfra-jcmd", ".txt");
    try {
      Process process =
          new ProcessBuilder(jcmd.toString(), Long.toString(pid), command)
              .redirectErrorStream(true)
              .redirectOutput(output.toFile())
              .start();
      process.getOutputStream().close();
      int exit = process.waitFor();
      String text = Files.readString(output);
      if (exit != 0) {
        throw new IOException("jcmd " + pid + " " + command + ": " + text.strip());
      }
      return text;
    } finally {
      Files.deleteIfExists(output);
    }
  }
}
