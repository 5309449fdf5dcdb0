package org.dfra.benchmarks.event;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.dfra.benchmarks.task.Task;

/**
 * A listener's process. Arguments: the {@link EventPeer} and the source's address. It prints {@code
 * listening}, and answers each line of its input: {@code clock} by {@code clock} and the time by
 * {@link System#nanoTime}; {@code report NUMBER} by {@code received} and {@code NUMBER:TIME} of
 * each event since the last report, when the event of that number has arrived. It ends with its
 * input, and fails if that event does not arrive.
 */
public final class EventListenerTask implements Task {

  private static final Duration PATIENCE = Duration.ofSeconds(20);

  @GuardedBy("this")
  private final List<String> received = new ArrayList<>();

  // number of the last event
  @GuardedBy("this")
  private long last;

  /** For {@link org.dfra.benchmarks.task.TaskProcess}. */
  public EventListenerTask() {}

  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    EventPeer.valueOf(args[0]).transport().listen(args[1], this::record);
    out.println("listening");
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
    for (String line; (line = in.readLine()) != null; ) {
      if (line.equals("clock")) {
        out.println("clock " + System.nanoTime());
      } else {
        out.println("received " + report(Long.parseLong(line.substring("report ".length()))));
      }
    }
  }

  private void record(long number) {
    long now = System.nanoTime();
    synchronized (this) {
      received.add(number + ":" + now);
      last = number;
      notifyAll();
    }
  }

  private synchronized String report(long number) throws IOException, InterruptedException {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (last < number) {
      long left = end - System.nanoTime();
      if (left <= 0) {
        throw new IOException("event " + number + " did not arrive; the last was " + last);
      }
      TimeUnit.NANOSECONDS.timedWait(this, left);
    }
    String all = String.join(" ", received);
    received.clear();
    return all;
  }
}
