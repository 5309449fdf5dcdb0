package org.dfra.benchmarks.event;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import org.dfra.benchmarks.event.EventTransport.ServedSource;
import org.dfra.benchmarks.task.Task;

/**
 * The source's process. Argument: the {@link EventPeer}. It prints {@code address ADDRESS}, and
 * answers each line of its input, {@code publish COUNT NANOSECONDS}, by {@code published} and the
 * times of these events by {@link System#nanoTime}, when it has published that many with that time
 * between them. It ends with its input.
 */
public final class EventServerTask implements Task {

  /** For {@link org.dfra.benchmarks.task.TaskProcess}. */
  public EventServerTask() {}

  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    ServedSource served = EventPeer.valueOf(args[0]).transport().serve();
    out.println("address " + served.address());
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
    for (String line; (line = in.readLine()) != null; ) {
      String[] words = line.split(" ", -1);
      long[] times = publish(served.source(), Integer.parseInt(words[1]), Long.parseLong(words[2]));
      out.println(
          "published "
              + LongStream.of(times).mapToObj(Long::toString).collect(Collectors.joining(" ")));
    }
  }

  private static long[] publish(EventTransport.EventSource source, int count, long period) {
    long[] times = new long[count];
    long next = System.nanoTime();
    for (int i = 0; i < count; i++) {
      times[i] = System.nanoTime();
      source.publish();
      next += period;
      for (long wait; (wait = next - System.nanoTime()) > 0; ) {
        LockSupport.parkNanos(source, wait);
      }
    }
    return times;
  }
}
