package org.dfra.benchmarks.call;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dfra.benchmarks.task.TaskProcess;

/** A server's process and a client's process that calls it, by one peer. Used by one thread. */
public final class PeerProcesses implements AutoCloseable {

  private static final Duration PATIENCE = Duration.ofMinutes(3);

  /**
   * In so many parts a measurement is divided; the counters are read between them, when nobody
   * calls. An ended thread then spoils one part only.
   */
  private static final int PARTS = 20;

  private final TaskProcess server;
  private final TaskProcess client;

  private PeerProcesses(TaskProcess server, TaskProcess client) {
    this.server = server;
    this.client = client;
  }

  /**
   * Starts both and connects them.
   *
   * @param cores where they run
   * @param jit their JIT compilers
   * @param folder an empty folder for files of the server
   * @throws IOException if one does not start; its message contains the log of that process
   */
  public static PeerProcesses start(
      CallPeer peer, CoreAssignment cores, JitSetting jit, Path folder)
      throws IOException, InterruptedException {
    List<String> options = new ArrayList<>(jit.options());
    options.addAll(peer.options());
    options.add("-Ddfra.transport.sockets=" + folder); // a killed server leaves its socket there
    TaskProcess server =
        TaskProcess.start(
            cores.serverPrefix(), options, CallServerTask.class, peer.name(), folder.toString());
    try {
      TaskProcess client =
          TaskProcess.start(cores.clientPrefix(), options, CallClientTask.class, peer.name());
      try {
        String address = server.awaitLine("address ", PATIENCE).substring("address ".length());
        client.write("connect " + address);
        String unused = client.awaitLine("connected", PATIENCE);
        return new PeerProcesses(server, client);
      } catch (IOException | InterruptedException | RuntimeException e) {
        client.close();
        throw e;
      }
    } catch (IOException | InterruptedException | RuntimeException e) {
      server.close();
      throw e;
    }
  }

  /** Process ID of the client. */
  public long clientPid() {
    return client.pid();
  }

  /** Process ID of the server. */
  public long serverPid() {
    return server.pid();
  }

  /** The server's answer to {@link EchoService#echo}, as the client receives it. */
  public long echo(long value) throws IOException, InterruptedException {
    return Long.parseLong(ask(client, "echo " + value, "answer "));
  }

  /** The server's answer to {@link EchoService#values}, as the client receives it. */
  public List<Double> values() throws IOException, InterruptedException {
    return Arrays.stream(ask(client, "values", "answer ").split(" ", -1))
        .map(Double::valueOf)
        .toList();
  }

  /**
   * Makes calls without measuring.
   *
   * @param calls how many
   */
  public void warmUp(CallKind kind, int calls) throws IOException, InterruptedException {
    load(kind, calls);
    CallTimes unused = times();
  }

  /**
   * Makes calls and measures them; the client checks each answer.
   *
   * @param calls how many
   * @throws IOException if a call fails or its answer is wrong
   */
  public CallMeasurement measure(CallKind kind, int calls)
      throws IOException, InterruptedException {
    ProcessUseCounter clientUse = new ProcessUseCounter();
    ProcessUseCounter serverUse = new ProcessUseCounter();
    int parts = kind.threads() == 1 ? Math.min(PARTS, calls) : 1; // threads need time to start
    for (int i = 0; i < parts; i++) {
      long clientEnded = ended(client);
      long serverEnded = ended(server);
      ProcessCounters clientBefore = ProcessCounters.of(client.pid());
      ProcessCounters serverBefore = ProcessCounters.of(server.pid());
      load(kind, calls / parts);
      ProcessCounters clientAfter = ProcessCounters.of(client.pid());
      ProcessCounters serverAfter = ProcessCounters.of(server.pid());
      clientUse.add(clientBefore, clientAfter, ended(client) - clientEnded, calls / parts);
      serverUse.add(serverBefore, serverAfter, ended(server) - serverEnded, calls / parts);
    }
    return new CallMeasurement(times(), clientUse.use(), serverUse.use());
  }

  private void load(CallKind kind, int calls) throws IOException, InterruptedException {
    String unused = ask(client, "load " + kind.command() + " " + calls, "done");
  }

  /** Of all calls since this was last called. */
  private CallTimes times() throws IOException, InterruptedException {
    return CallTimes.parse(ask(client, "times", "times "));
  }

  private static long ended(TaskProcess process) throws IOException, InterruptedException {
    return Long.parseLong(ask(process, "threads", "ended "));
  }

  private static String ask(TaskProcess process, String command, String prefix)
      throws IOException, InterruptedException {
    process.write(command);
    return process.awaitLine(prefix, PATIENCE).substring(prefix.length());
  }

  /** Kills both. */
  @Override
  public void close() throws InterruptedException {
    try {
      client.close();
    } finally {
      server.close();
    }
  }
}
