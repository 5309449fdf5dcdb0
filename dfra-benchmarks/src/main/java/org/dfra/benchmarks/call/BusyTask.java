package org.dfra.benchmarks.call;

import java.io.PrintStream;
import org.dfra.benchmarks.task.Task;

/** Keeps its core from sleeping, until its process is killed. It prints {@code busy} first. */
public final class BusyTask implements Task {

  /** For {@link org.dfra.benchmarks.task.TaskProcess}. */
  public BusyTask() {}

  @Override
  public void run(String[] args, PrintStream out) {
    out.println("busy");
    while (!Thread.currentThread().isInterrupted()) {
      Thread.onSpinWait();
    }
  }
}
