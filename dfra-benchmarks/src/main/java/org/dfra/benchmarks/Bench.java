package org.dfra.benchmarks;

/** A benchmark. */
interface Bench {

  /** Measures and reports. */
  void run(Report report) throws Exception;
}
