package org.dfra.examples.harness;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * The current speed of this computer, with all its processors, relative to the reference computer
 * of the demonstrations: two processors, otherwise idle. Other running programs reduce it.
 */
public final class CpuSpeed {

  /** Rounds per second of the reference computer, both processors together. */
  private static final double REFERENCE = 9_000;

  private static final int WORDS = 1 << 15; // 256 KiB: more than the L1 cache, like real programs
  private static final long WARM_UP = TimeUnit.MILLISECONDS.toNanos(200); // JIT warm-up
  private static final long MEASURED = TimeUnit.MILLISECONDS.toNanos(150);
  private static final int TIMES = 3; // the best round counts: others may be disturbed

  private CpuSpeed() {}

  /**
   * Measures it for two thirds of a second; 1 is the speed of the reference, 0 if it is
   * interrupted.
   */
  public static double relativeToReference() {
    List<Worker> workers = new ArrayList<>();
    for (int i = 0; i < Runtime.getRuntime().availableProcessors(); i++) {
      Worker worker = new Worker();
      workers.add(worker);
      worker.start();
    }
    double rounds = 0;
    try {
      for (Worker worker : workers) {
        worker.join();
        rounds += worker.rate;
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // the caller is ending; the threads end by themselves
      return 0;
    }
    return rounds / REFERENCE;
  }

  /** Keeps one processor busy. */
  private static final class Worker extends Thread {
    private final long[] words = new long[WORDS];
    private double rate; // rounds per second; read after the thread has ended
    private long sum; // prevents dead-code elimination

    Worker() {
      super("dfra-power");
      setDaemon(true);
    }

    @Override
    public void run() {
      for (int i = 0; i < WORDS; i++) {
        words[i] = i * 0x9E3779B97F4A7C15L;
      }
      double unused = work(WARM_UP);
      for (int i = 0; i < TIMES; i++) {
        rate = Math.max(rate, work(MEASURED));
      }
    }

    /** Rounds per second. */
    private double work(long nanos) {
      long began = System.nanoTime();
      long rounds = 0;
      long taken;
      do {
        round();
        rounds++;
        taken = System.nanoTime() - began;
      } while (taken < nanos);
      return 1e9 * rounds / taken;
    }

    /** Mixes numbers; each step depends on the result of the last at another address. */
    private void round() {
      long at = sum;
      for (int i = 0; i < WORDS; i++) {
        long word = words[(int) (at & (WORDS - 1))];
        at = (at ^ word ^ i) * 0xBF58476D1CE4E5B9L;
        at ^= at >>> 29;
        words[i] = at;
      }
      sum = at;
    }
  }
}
