package org.dfra.benchmarks.call;

/**
 * One measurement of a peer in one repetition.
 *
 * @param times duration of its calls
 * @param client use of the client's process
 * @param server use of the server's process
 */
public record CallMeasurement(CallTimes times, Use client, Use server) {

  /**
   * What a process used.
   *
   * @param switchesPerCall voluntary context switches for a call, of the threads that live after
   *     the measurement; NaN if this computer does not count them
   * @param cpuPerCall CPU time for a call, microseconds; of all threads, also those of the compiler
   *     and the garbage collector
   * @param endedThreads how many threads ended meanwhile, whose switches are not counted
   */
  public record Use(double switchesPerCall, double cpuPerCall, long endedThreads) {

    static Use between(
        ProcessCounters before, ProcessCounters after, long endedJavaThreads, int calls) {
      return new Use(
          after.switches().isEmpty() ? Double.NaN : (double) after.switchesSince(before) / calls,
          after.cpuMicrosSince(before) / calls,
          Math.max(after.endedSince(before), endedJavaThreads));
    }
  }
}
