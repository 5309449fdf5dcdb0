package org.dfra.attack.fuzz;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import org.dfra.attack.kit.Victim;
import org.dfra.benchmarks.attack.ProcessSample;

/**
 * What messages of a kind may cost a process, and how many were sent. A soak's figures are recorded
 * when it is closed, whether all went well or not.
 */
final class FuzzProgress implements AutoCloseable {

  private static final boolean SOAK = Boolean.getBoolean("dfra.soak");

  /** Of threads that pools keep for a while. */
  private static final int POOLED = Victim.THREADS;

  private static final Path RECORD =
      Path.of(System.getProperty("dfra.root", ""), "benchmarks", "fuzz-soak.csv");

  private final long seed;
  private final String what;
  private final int total;
  private final long pid;
  private final Runnable alive;
  private final Victim victim;
  private final long began;
  private int count;
  private double seconds;
  private boolean hasPassed;

  /**
   * Begins.
   *
   * @param seed of the random numbers that changed the messages
   * @param what they are
   * @param total how many are to be sent
   * @param pid of the process that receives them
   * @param alive asserts that no thread of it ended
   */
  FuzzProgress(long seed, String what, int total, long pid, Runnable alive)
      throws IOException, InterruptedException {
    this.seed = seed;
    this.what = what;
    this.total = total;
    this.pid = pid;
    this.alive = alive;
    this.victim = Victim.of(pid);
    this.began = System.nanoTime();
  }

  /** Asserts, after so many messages, that they cost no memory and ended no thread. */
  void reached(int messages) {
    count = messages;
    seconds = (System.nanoTime() - began) / 1e9;
    victim.assertRecovers(POOLED, Victim.HEAP);
    alive.run();
    print();
    hasPassed = count == total;
  }

  @Override
  public void close() throws IOException, InterruptedException {
    if (!SOAK) {
      return;
    }
    FuzzFigures figures = new FuzzFigures(seed);
    figures.add(what, count, Math.max(seconds, 1e-3), hasPassed ? 0 : 1);
    try {
      figures.addProcess(what, victim.before(), ProcessSample.of(pid));
    } catch (IOException e) { // it has ended, and the failure is recorded
      System.err.println("no figures of process " + pid + ": " + e);
    }
    figures.record(RECORD);
  }

  private void print() {
    System.out.printf(
        Locale.ROOT,
        "%d of %d changed %s in %.1f s, %.0f/s; %s%n",
        count,
        total,
        what,
        seconds,
        count / seconds,
        "-Ddfra.seed=" + seed);
  }
}
