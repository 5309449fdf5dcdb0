package org.dfra.attack.kit;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.dfra.benchmarks.task.Task;

/**
 * A process that is harmed: with each line of its input it begins to hold threads, and half a
 * megabyte of heap for each.
 */
public final class HoldThreads implements Task {

  private static final int HALF_A_MEGABYTE = 1 << 19;

  private final List<byte[]> held = new ArrayList<>();

  /** As every task is made. */
  public HoldThreads() {}

  /** Argument: how many threads. */
  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    int count = Integer.parseInt(args[0]);
    CountDownLatch never = new CountDownLatch(1);
    out.println("ready");
    while (System.in.read() == '\n') {
      for (int i = 0; i < count; i++) {
        held.add(new byte[HALF_A_MEGABYTE]);
        Thread thread =
            new Thread(
                () -> {
                  try {
                    never.await();
                  } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                  }
                },
                "held " + i);
        thread.setDaemon(true);
        thread.start();
      }
      out.println("holds " + held.size());
    }
  }
}
