package org.dfra.benchmarks.call;

import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;

/** The called object. It computes nothing, so that only the call is measured. */
public final class EchoServer implements EchoService {

  /** What {@link #values} returns. */
  public static final List<Double> EXPECTED =
      DoubleStream.iterate(0, i -> i + 1)
          .limit(VALUES)
          .map(i -> 2 + 10 * Math.abs(Math.sin(0.03 * i)))
          .boxed()
          .toList();

  private static final double[] ANSWER = expected();

  /** An object to export. */
  EchoServer() {}

  /** A copy of what {@link #values} returns. */
  static double[] expected() {
    return EXPECTED.stream().mapToDouble(Double::doubleValue).toArray();
  }

  /** Whether these are the numbers that {@link #values} returns. */
  static boolean isExpected(double[] values) {
    return Arrays.equals(values, ANSWER);
  }

  @Override
  public long echo(long value) {
    return value;
  }

  @Override
  public double[] values() {
    return ANSWER; // it is written to the answer, not handed on
  }
}
