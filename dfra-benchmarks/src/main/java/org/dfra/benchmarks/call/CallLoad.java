package org.dfra.benchmarks.call;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.LongStream;

/**
 * Calls a server, checks each answer, and times each call. Its threads live until {@link #close},
 * so that the kernel's counters of the process do not lose those of an ended thread. Used by one
 * thread.
 */
final class CallLoad implements AutoCloseable {

  private final CallTransport.Connection connection;
  private final List<Caller> callers = new ArrayList<>();

  // as many threads as have called at once
  private final ExecutorService threads =
      Executors.newCachedThreadPool(
          task -> {
            Thread thread = new Thread(task, "caller");
            thread.setDaemon(true);
            return thread;
          });

  private final List<long[]> nanos = new ArrayList<>(); // of each share since the last times()
  private long elapsed; // of these, nanoseconds
  private long number;

  CallLoad(CallTransport.Connection connection) {
    this.connection = connection;
  }

  /** What one thread has measured, by {@link System#nanoTime}. */
  private record Share(long began, long ended, long[] nanos) {}

  /**
   * Makes calls.
   *
   * @param calls how many, at least one for each thread of the kind; rounded down to a multiple of
   *     their number
   * @throws IOException if a call fails or its answer is wrong
   */
  void run(CallKind kind, int calls) throws IOException, InterruptedException {
    int each = calls / kind.threads();
    if (each < 1) {
      throw new IllegalArgumentException(
          calls
              + " calls are too few for "
              + kind.threads()
              + " threads; make at least one by each");
    }
    while (callers.size() < kind.threads()) {
      callers.add(connection.caller());
    }
    number += calls;
    add(
        kind.threads() == 1
            ? List.of(share(kind, callers.get(0), each, number))
            : together(kind, each));
  }

  private List<Share> together(CallKind kind, int each) throws IOException, InterruptedException {
    CyclicBarrier start = new CyclicBarrier(kind.threads());
    List<Future<Share>> running = new ArrayList<>();
    for (Caller caller : callers.subList(0, kind.threads())) {
      long first = number + (long) running.size() * each;
      running.add(
          threads.submit(
              () -> {
                int unused = start.await();
                return share(kind, caller, each, first);
              }));
    }
    List<Share> shares = new ArrayList<>();
    for (Future<Share> share : running) {
      try {
        shares.add(share.get());
      } catch (ExecutionException e) {
        throw new IOException("one of " + kind.threads() + " threads failed", e.getCause());
      }
    }
    return shares;
  }

  private static Share share(CallKind kind, Caller caller, int calls, long first)
      throws IOException {
    long[] nanos = new long[calls];
    long began = System.nanoTime();
    long before = began;
    for (int i = 0; i < calls; i++) {
      kind.call(caller, first + i);
      long after = System.nanoTime();
      nanos[i] = after - before;
      before = after;
    }
    return new Share(began, before, nanos);
  }

  private void add(List<Share> shares) {
    elapsed +=
        shares.stream().mapToLong(Share::ended).max().orElseThrow()
            - shares.stream().mapToLong(Share::began).min().orElseThrow();
    shares.forEach(each -> nanos.add(each.nanos()));
  }

  /** Of all calls since this was last called, at least one. */
  CallTimes times() {
    CallTimes times = CallTimes.of(nanos.stream().flatMapToLong(LongStream::of).toArray(), elapsed);
    nanos.clear();
    elapsed = 0;
    return times;
  }

  @Override
  public void close() {
    threads.shutdownNow();
    callers.forEach(Caller::close);
  }
}
