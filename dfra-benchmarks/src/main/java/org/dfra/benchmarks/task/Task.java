package org.dfra.benchmarks.task;

import java.io.PrintStream;

/** The task of a separate process. A public class with a public constructor without parameters. */
@FunctionalInterface
public interface Task {

  /**
   * Executes the task. The process ends when this returns.
   *
   * @param args from the starting process
   * @param out lines for the starting process; {@code System.out} and {@code System.err} go to a
   *     log that it shows after a failure
   * @throws Exception on failure; it is logged, and the process ends with exit code 1
   */
  void run(String[] args, PrintStream out) throws Exception;
}
