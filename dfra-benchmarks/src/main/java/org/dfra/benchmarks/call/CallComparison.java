package org.dfra.benchmarks.call;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.dfra.benchmarks.call.CallCondition.ConditionUnavailableException;
import org.dfra.benchmarks.task.TaskProcess;

/**
 * Compares peers under one condition: in each repetition each peer once, each time in two new
 * processes. So a disturbance that lasts longer than a repetition affects all peers, and hardly
 * their ratios. The first peer of a repetition is another one than that of the repetition before.
 */
public final class CallComparison {

  private static final Duration PATIENCE = Duration.ofMinutes(1);
  private static final long ECHOED = -361_002_004L;

  private final CallCondition condition;
  private final JitSetting jit;
  private final List<CallPeer> peers;
  private final CallSettings settings;

  /**
   * @param peers what is compared; {@link CallPeer#REFERENCE} is one of them
   */
  public CallComparison(
      CallCondition condition, JitSetting jit, List<CallPeer> peers, CallSettings settings) {
    if (!peers.contains(CallPeer.REFERENCE)) {
      throw new IllegalArgumentException(
          CallPeer.REFERENCE + " is not among " + peers + "; the others are compared with it");
    }
    this.condition = condition;
    this.jit = jit;
    this.peers = List.copyOf(peers);
    this.settings = settings;
  }

  /** Where the processes run. */
  public CallCondition condition() {
    return condition;
  }

  /** What is compared, before the names of the figures. */
  public String title() {
    return condition.label() + ", " + jit.label();
  }

  /**
   * What this computer lacks to have a condition; empty if it can.
   *
   * @throws IOException if the computer's state cannot be read
   */
  public static Optional<String> missing(CallCondition condition)
      throws IOException, InterruptedException {
    try {
      CoreAssignment unused = condition.assign(Cores.ofThisComputer());
      return Optional.empty();
    } catch (ConditionUnavailableException e) {
      return Optional.of(e.need());
    }
  }

  /**
   * The cores of this computer that a condition uses.
   *
   * @throws IOException if this computer cannot have the condition
   */
  public static CoreAssignment cores(CallCondition condition)
      throws IOException, InterruptedException {
    try {
      return condition.assign(Cores.ofThisComputer());
    } catch (ConditionUnavailableException e) {
      throw new IOException("\"" + condition.label() + "\" needs " + e.need(), e);
    }
  }

  /**
   * Measures.
   *
   * @param progress is notified of each repetition
   * @throws IOException if the condition is unavailable here, a process does not start, a call
   *     fails or its answer is wrong
   */
  public CallResults run(Consumer<String> progress) throws IOException, InterruptedException {
    CoreAssignment cores = cores(condition);
    CallResults results = new CallResults(title());
    List<TaskProcess> busy = new ArrayList<>();
    try {
      for (List<String> prefix : cores.busyPrefixes()) {
        busy.add(TaskProcess.start(prefix, List.of(), BusyTask.class));
      }
      for (TaskProcess each : busy) {
        String unused = each.awaitLine("busy", PATIENCE);
      }
      for (int i = 0; i < settings.repetitions(); i++) {
        List<CallPeer> order = new ArrayList<>(peers);
        Collections.rotate(order, -i);
        progress.accept(
            title()
                + ": repetition "
                + (i + 1)
                + " of "
                + settings.repetitions()
                + ", "
                + String.join(", ", order.stream().map(CallPeer::label).toList())
                + " …");
        for (CallPeer peer : order) {
          measure(peer, cores, results);
        }
      }
    } finally {
      for (TaskProcess each : busy) {
        each.close();
      }
    }
    return results;
  }

  private void measure(CallPeer peer, CoreAssignment cores, CallResults results)
      throws IOException, InterruptedException {
    Path folder = Files.createTempDirectory("dfra-call-");
    try (PeerProcesses processes = PeerProcesses.start(peer, cores, jit, folder)) {
      check(peer, processes);
      for (CallKind kind : CallKind.values()) {
        processes.warmUp(kind, settings.warmUp(kind));
        results.add(peer, kind, processes.measure(kind, settings.calls(kind)));
      }
    } finally {
      delete(folder);
    }
  }

  private static void check(CallPeer peer, PeerProcesses processes)
      throws IOException, InterruptedException {
    long echo = processes.echo(ECHOED);
    List<Double> values = processes.values();
    if (echo != ECHOED || !values.equals(EchoServer.EXPECTED)) {
      throw new IOException(
          peer.label()
              + " answered "
              + echo
              + " instead of "
              + ECHOED
              + ", or other doubles than its server has: "
              + values);
    }
  }

  /** The server may have left a socket there. */
  private static void delete(Path folder) throws IOException {
    try (Stream<Path> all = Files.walk(folder)) {
      for (Path each : all.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(each);
      }
    }
  }
}
