package org.dfra.app.bench;

/** A benchmark. */
interface Bench {

  /** Measures and reports. */
  void run(Report report) throws Exception;
}
