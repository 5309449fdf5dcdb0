package org.dfra.app.benchmark;

/** A benchmark. */
interface Bench {

  /** Measures and reports. */
  void run(Report report) throws Exception;
}
