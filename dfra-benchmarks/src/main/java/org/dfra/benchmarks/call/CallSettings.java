package org.dfra.benchmarks.call;

import java.util.List;

/**
 * How much is measured.
 *
 * @param repetitions how often each peer is measured under each condition, each time in two new
 *     processes
 * @param smallWarmUp small calls before, to warm up
 * @param smallCalls small calls that are measured
 * @param valuesWarmUp the same for calls that return many doubles
 * @param valuesCalls likewise measured
 * @param callersWarmUp the same for calls by many threads, of all threads together
 * @param callersCalls likewise measured
 */
public record CallSettings(
    int repetitions,
    int smallWarmUp,
    int smallCalls,
    int valuesWarmUp,
    int valuesCalls,
    int callersWarmUp,
    int callersCalls) {

  /** For records. */
  public static final CallSettings FULL =
      new CallSettings(5, 20_000, 10_000, 5_000, 5_000, 10_000, 20_000);

  /** To try it; the figures are not to be compared. */
  public static final CallSettings QUICK = new CallSettings(1, 1_000, 500, 200, 200, 640, 640);

  /** How many calls of a kind are made before, to warm up. */
  int warmUp(CallKind kind) {
    return of(kind, List.of(smallWarmUp, valuesWarmUp, callersWarmUp));
  }

  /** How many calls of a kind are measured. */
  public int calls(CallKind kind) {
    return of(kind, List.of(smallCalls, valuesCalls, callersCalls));
  }

  private static int of(CallKind kind, List<Integer> byKind) {
    return byKind.get(kind.ordinal());
  }
}
