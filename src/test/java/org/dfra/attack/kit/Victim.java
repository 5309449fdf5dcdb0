package org.dfra.attack.kit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.time.Duration;
import org.dfra.benchmarks.attack.ProcessSample;

/**
 * A process that is attacked, and what it used before. It is harmed if it uses more than the
 * requirements allow: {@value #THREADS} threads, {@link #HEAP} bytes of heap, {@link #CPU} for each
 * refused call; and it has {@link #RECOVERY} to return to what it was.
 */
public final class Victim {

  /** How many threads an attack may cost. */
  public static final int THREADS = 64;

  /** How many bytes of heap an attack may cost. */
  public static final long HEAP = 8L << 20;

  /** How much CPU time a refused call may cost. */
  public static final Duration CPU = Duration.ofSeconds(1);

  /** How long after an attack a process may take to return to what it was. */
  public static final Duration RECOVERY = Duration.ofSeconds(10);

  private static final Duration POLL = Duration.ofMillis(100);

  private final long pid;
  private final ProcessSample before;

  private Victim(long pid, ProcessSample before) {
    this.pid = pid;
    this.before = before;
  }

  /**
   * A process as it is before an attack.
   *
   * @param pid a virtual machine of this user
   */
  public static Victim of(long pid) throws IOException, InterruptedException {
    return new Victim(pid, ProcessSample.of(pid));
  }

  /** What it used before. */
  public ProcessSample before() {
    return before;
  }

  /** How many threads it has more than before. */
  public int moreThreads() throws IOException, InterruptedException {
    return ProcessSample.threads(pid) - before.threads();
  }

  /** How many bytes of objects it has more than before; it collects its garbage for that. */
  public long moreHeap() throws IOException, InterruptedException {
    return ProcessSample.heapBytes(pid) - before.heapBytes();
  }

  /** The CPU time it has used since. */
  public Duration cpuSince() throws IOException {
    return ProcessSample.cpu(pid).minus(before.cpu());
  }

  /** Asserts, in the midst of an attack, that it costs few threads and little heap. */
  public void assertWithinLimits() throws IOException, InterruptedException {
    assertThat(moreThreads()).as("threads of process " + pid + " above before").isLessThan(THREADS);
    assertThat(moreHeap()).as("heap of process " + pid + " above before").isLessThan(HEAP);
  }

  /**
   * Asserts that it used little CPU time since.
   *
   * @param calls how many calls it had to refuse, at least 1
   */
  public void assertCpuPerCall(int calls) throws IOException {
    assertThat(cpuSince())
        .as("CPU time of process " + pid + " for " + calls + " refused calls")
        .isLessThan(CPU.multipliedBy(calls));
  }

  /**
   * Asserts that within {@link #RECOVERY} it uses what it used before.
   *
   * @param threads how many threads may stay, for pools that keep them
   * @param heapBytes how many bytes of heap may stay
   */
  public void assertRecovers(int threads, long heapBytes) {
    await("process " + pid + " returns to what it was before the attack, " + before)
        .atMost(RECOVERY)
        .pollInterval(POLL)
        .untilAsserted(() -> assertThat(moreThreads()).as("threads").isLessThanOrEqualTo(threads));
    await("process " + pid + " returns to what it was before the attack, " + before)
        .atMost(RECOVERY)
        .pollInterval(RECOVERY.dividedBy(5)) // each look is a full collection
        .pollDelay(Duration.ZERO)
        .untilAsserted(
            () -> assertThat(moreHeap()).as("bytes of heap").isLessThanOrEqualTo(heapBytes));
  }
}
