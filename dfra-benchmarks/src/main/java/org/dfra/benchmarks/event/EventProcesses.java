package org.dfra.benchmarks.event;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.dfra.benchmarks.task.TaskProcess;

/** A source's process and its listeners' processes, of one peer. Used by one thread. */
public final class EventProcesses implements AutoCloseable {

  private static final Duration PATIENCE = Duration.ofMinutes(3);

  /** So many processes start at a time: twenty would miss the deadlines of their first calls. */
  private static final int STARTING = 3;

  private static final double NANOS_PER_MICRO = 1e3;

  private final TaskProcess source;
  private final List<TaskProcess> listeners = new ArrayList<>();
  private long published;

  private EventProcesses(TaskProcess source) {
    this.source = source;
  }

  /**
   * Starts all and connects them.
   *
   * @param count how many listeners
   * @throws IOException if one does not start, or clocks of processes cannot be compared here
   */
  public static EventProcesses start(EventPeer peer, int count)
      throws IOException, InterruptedException {
    EventProcesses started =
        new EventProcesses(TaskProcess.start(EventServerTask.class, peer.name()));
    try {
      started.startListeners(peer, count);
      return started;
    } catch (IOException | InterruptedException | RuntimeException e) {
      started.close();
      throw e;
    }
  }

  private void startListeners(EventPeer peer, int count) throws IOException, InterruptedException {
    String address = source.awaitLine("address ", PATIENCE).substring("address ".length());
    for (int i = 0; i < count; i++) {
      listeners.add(
          TaskProcess.start(
              List.of(), List.of("-Xmx64m"), EventListenerTask.class, peer.name(), address));
      if (i >= STARTING) {
        String unused = listeners.get(i - STARTING).awaitLine("listening", PATIENCE);
      }
    }
    for (TaskProcess each : listeners.subList(Math.max(0, count - STARTING), count)) {
      String unused = each.awaitLine("listening", PATIENCE);
    }
    for (TaskProcess each : listeners) {
      checkClock(each);
    }
  }

  /** On Linux, {@link System#nanoTime} of all processes has one origin. */
  private static void checkClock(TaskProcess listener) throws IOException, InterruptedException {
    long before = System.nanoTime();
    listener.write("clock");
    long there =
        Long.parseLong(listener.awaitLine("clock ", PATIENCE).substring("clock ".length()));
    if (there < before || there > System.nanoTime()) {
      throw new IOException("the clocks of two processes cannot be compared on this computer");
    }
  }

  /**
   * Publishes events without measuring. While nothing is compiled yet, some may be lost.
   *
   * @param events how many
   * @param period time between two
   * @throws IOException if the last does not arrive
   */
  public void warmUp(int events, Duration period) throws IOException, InterruptedException {
    List<Map<Long, Long>> unused = publish(events, period, new long[events]);
  }

  /**
   * Publishes events, and measures when each reaches each listener.
   *
   * @param events how many
   * @param period time between two
   * @throws IOException if the last does not arrive, or one arrives twice
   */
  public EventTimes measure(int events, Duration period) throws IOException, InterruptedException {
    Duration before = cpu();
    long first = published + 1;
    long[] times = new long[events];
    long[] latencies = new long[events * listeners.size()];
    int count = 0;
    for (Map<Long, Long> received : publish(events, period, times)) {
      for (int i = 0; i < events; i++) {
        Long at = received.get(first + i);
        if (at != null) {
          latencies[count++] = at - times[i];
        }
      }
    }
    return EventTimes.of(
        Arrays.copyOf(latencies, count),
        cpu().minus(before).toNanos() / NANOS_PER_MICRO / latencies.length,
        latencies.length - count);
  }

  /** Publishes events; returns their times of arrival at each listener, by number. */
  private List<Map<Long, Long>> publish(int events, Duration period, long[] times)
      throws IOException, InterruptedException {
    source.write("publish " + events + " " + period.toNanos());
    long[] sent = numbers(source.awaitLine("published ", PATIENCE));
    System.arraycopy(sent, 0, times, 0, events);
    published += events;
    List<Map<Long, Long>> received = new ArrayList<>();
    for (TaskProcess each : listeners) {
      each.write("report " + published);
      received.add(received(each.awaitLine("received ", PATIENCE)));
    }
    return received;
  }

  private static long[] numbers(String line) {
    return Arrays.stream(line.split(" ", -1)).skip(1).mapToLong(Long::parseLong).toArray();
  }

  private static Map<Long, Long> received(String line) throws IOException {
    Map<Long, Long> received = new HashMap<>();
    for (String each : line.substring("received ".length()).split(" ", -1)) {
      String[] words = each.split(":", -1);
      if (received.put(Long.valueOf(words[0]), Long.valueOf(words[1])) != null) {
        throw new IOException("a listener received event " + words[0] + " twice");
      }
    }
    return received;
  }

  private Duration cpu() {
    return Stream.concat(Stream.of(source), listeners.stream())
        .flatMap(each -> ProcessHandle.of(each.pid()).stream())
        .map(each -> each.info().totalCpuDuration())
        .flatMap(Optional::stream)
        .reduce(Duration.ZERO, Duration::plus);
  }

  /** Process IDs, the source's first. */
  public List<Long> pids() {
    return LongStream.concat(
            LongStream.of(source.pid()), listeners.stream().mapToLong(TaskProcess::pid))
        .boxed()
        .toList();
  }

  /** Kills all. */
  @Override
  public void close() throws InterruptedException {
    try {
      for (TaskProcess each : listeners) {
        each.close();
      }
    } finally {
      source.close();
    }
  }
}
