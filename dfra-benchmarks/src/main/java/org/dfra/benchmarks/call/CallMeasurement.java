package org.dfra.benchmarks.call;

/**
 * One measurement of a peer in one repetition.
 *
 * @param times duration of its calls
 * @param client use of the client's process
 * @param server use of the server's process
 */
public record CallMeasurement(CallTimes times, ProcessUse client, ProcessUse server) {

  /**
   * What a process used.
   *
   * @param switchesPerCall voluntary context switches for a call; NaN if this computer does not
   *     count them
   * @param isComplete whether these are the switches of all threads. The kernel forgets those of a
   *     thread that ends, so only the parts of the measurement count in which none ended; false if
   *     there is no such part, and the switches are too few
   * @param cpuPerCall CPU time for a call, microseconds; of all threads, also those of the compiler
   *     and the garbage collector
   */
  public record ProcessUse(double switchesPerCall, boolean isComplete, double cpuPerCall) {}
}
