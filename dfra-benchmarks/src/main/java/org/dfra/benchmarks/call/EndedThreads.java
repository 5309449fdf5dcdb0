package org.dfra.benchmarks.call;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/** How many Java threads of this virtual machine have ended: their counters are lost. */
final class EndedThreads {

  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

  private EndedThreads() {}

  /** Since the start. */
  static long count() {
    return THREADS.getTotalStartedThreadCount() - THREADS.getThreadCount();
  }
}
