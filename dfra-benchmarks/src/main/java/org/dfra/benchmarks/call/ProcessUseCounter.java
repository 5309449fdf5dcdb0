package org.dfra.benchmarks.call;

import org.dfra.benchmarks.call.CallMeasurement.ProcessUse;

/** Adds up what a process uses in the parts of a measurement. Used by one thread. */
final class ProcessUseCounter {

  /** The switches of some parts, and their calls. */
  private record Sum(long switches, long calls) {

    static final Sum NONE = new Sum(0, 0);

    Sum plus(long moreSwitches, long moreCalls) {
      return new Sum(switches + moreSwitches, calls + moreCalls);
    }

    double perCall() {
      return (double) switches / calls;
    }
  }

  private Sum all = Sum.NONE;
  private Sum complete = Sum.NONE;
  private double cpuMicros;
  private boolean isCounted = true;

  /**
   * Adds a part.
   *
   * @param before counters before its first call
   * @param after counters after its last call
   * @param endedJavaThreads how many Java threads of the process ended meanwhile
   * @param calls number of its calls
   */
  void add(ProcessCounters before, ProcessCounters after, long endedJavaThreads, long calls) {
    long switches = after.switchesSince(before);
    all = all.plus(switches, calls);
    if (endedJavaThreads == 0 && after.endedSince(before) == 0) {
      complete = complete.plus(switches, calls);
    }
    cpuMicros += after.cpuMicrosSince(before);
    isCounted &= !after.switches().isEmpty();
  }

  /** Of all parts so far, at least one. */
  ProcessUse use() {
    boolean isComplete = complete.calls() > 0;
    double perCall = (isComplete ? complete : all).perCall();
    return new ProcessUse(
        isCounted ? perCall : Double.NaN, isComplete, cpuMicros / Math.max(1, all.calls()));
  }
}
