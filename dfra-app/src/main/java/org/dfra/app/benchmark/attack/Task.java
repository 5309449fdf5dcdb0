package org.dfra.app.benchmark.attack;

import java.io.PrintStream;

/**
 * What a process of its own is to do. A public class with a public constructor without parameters.
 */
@FunctionalInterface
public interface Task {

  /**
   * Does it. The process ends when this returns.
   *
   * @param args what its starter gave
   * @param out lines for the starter; what goes to {@code System.out} and {@code System.err} is a
   *     log that the starter shows when something fails
   * @throws Exception what went wrong; it is logged, and the process ends with exit code 1
   */
  void run(String[] args, PrintStream out) throws Exception;
}
