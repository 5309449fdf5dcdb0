package org.dfra.benchmarks.call;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.Set;
import java.util.concurrent.BrokenBarrierException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class CallLoadTest {

  /** Answers like a server, unless a test overrides it. */
  private static class LocalCaller implements Caller {

    private final EchoServer server = new EchoServer();

    @Override
    public long echo(long value) throws IOException {
      return server.echo(value);
    }

    @Override
    public double[] values() {
      return server.values();
    }
  }

  @Test
  void timesEachCallOnceAndThenForgetsIt() throws Exception {
    try (CallLoad load = new CallLoad(LocalCaller::new)) {
      load.run(CallKind.SMALL, 30);
      load.run(CallKind.VALUES, 12);
      CallTimes times = load.times();
      assertThat(times.calls()).isEqualTo(42);
      assertThat(times.p50()).isPositive().isLessThanOrEqualTo(times.p99());
      load.run(CallKind.SMALL, 7);
      assertThat(load.times().calls()).isEqualTo(7);
    }
  }

  @Test
  void failsIfAnEchoIsWrong() throws Exception {
    Caller wrong =
        new LocalCaller() {
          @Override
          public long echo(long value) {
            return value + 1;
          }
        };
    try (CallLoad load = new CallLoad(() -> wrong)) {
      assertThatThrownBy(() -> load.run(CallKind.SMALL, 10))
          .isInstanceOf(IOException.class)
          .hasMessageMatching("the server answered (\\d+) instead of (\\d+)");
      assertThatThrownBy(() -> load.run(CallKind.CALLERS, 64))
          .isInstanceOf(IOException.class)
          .hasRootCauseMessage(
              "the server answered %d instead of %d",
              firstOf(10, 64) + 1, firstOf(10, 64)); // the first thread's first call
    }
  }

  /** The argument of the first call of a load, after one before it. */
  private static long firstOf(int callsBefore, int calls) {
    return callsBefore + calls;
  }

  @Test
  void failsIfADoubleIsWrong() throws Exception {
    Caller wrong =
        new LocalCaller() {
          @Override
          public double[] values() {
            double[] values = super.values().clone();
            values[values.length - 1]++;
            return values;
          }
        };
    try (CallLoad load = new CallLoad(() -> wrong)) {
      assertThatThrownBy(() -> load.run(CallKind.VALUES, 1))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("361 doubles");
    }
  }

  /** Each call waits for one of every other thread. */
  @Test
  void callsByAllThreadsAtOnceAndNoNumberTwice() throws Exception {
    int threads = CallKind.CALLERS.threads();
    CyclicBarrier together = new CyclicBarrier(threads);
    Set<Long> numbers = ConcurrentHashMap.newKeySet();
    CallTransport.Connection connection =
        () ->
            new LocalCaller() {
              @Override
              public long echo(long value) throws IOException {
                try {
                  int unused = together.await(30, TimeUnit.SECONDS);
                } catch (InterruptedException | BrokenBarrierException | TimeoutException e) {
                  throw new IOException("not all threads call at once", e);
                }
                numbers.add(value);
                return value;
              }
            };
    try (CallLoad load = new CallLoad(connection)) {
      load.run(CallKind.CALLERS, 3 * threads + 1); // rounded down
      assertThat(load.times().calls()).isEqualTo(3 * threads);
    }
    assertThat(numbers).hasSize(3 * threads);
  }

  @Test
  void refusesFewerCallsThanThreads() throws Exception {
    try (CallLoad load = new CallLoad(LocalCaller::new)) {
      assertThatThrownBy(() -> load.run(CallKind.CALLERS, 31))
          .hasMessage("31 calls are too few for 32 threads; make at least one by each");
    }
  }
}
