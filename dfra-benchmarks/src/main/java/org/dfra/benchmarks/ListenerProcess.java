package org.dfra.benchmarks;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.Writer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.dfra.river.bootstrap.JvmCommand;
import org.jspecify.annotations.Nullable;

/** A {@link ListenerMain} process and its command protocol. */
final class ListenerProcess implements AutoCloseable {

  private final Process process;
  private final BufferedReader from;
  private final Writer to;

  /** Starts the process without waiting for it. */
  ListenerProcess(String locator) throws IOException {
    List<String> command = new ArrayList<>(List.of(JvmCommand.java()));
    command.addAll(JvmCommand.options());
    command.addAll(List.of("-Xmx64m", "-DDFRA_LOG=ERROR", ListenerMain.class.getName(), locator));
    process = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start();
    from = process.inputReader();
    to = process.outputWriter();
  }

  /** Waits until it has subscribed. */
  void awaitReady() throws IOException {
    String output = line();
    if (!output.equals("ready")) {
      throw new IOException("a listener's process said: " + output);
    }
  }

  /**
   * Checks that its {@link System#nanoTime} has the same origin as this process's, as between
   * processes of one machine on Linux (CLOCK_MONOTONIC).
   */
  void checkClock() throws IOException {
    long before = System.nanoTime();
    long there = Long.parseLong(ask("clock"));
    long after = System.nanoTime();
    if (there < before || there > after) {
      throw new IOException(
          "the clocks of two processes cannot be compared here: "
              + there
              + " ns is not from "
              + before
              + " to "
              + after);
    }
  }

  /**
   * Makes it send a message to the agent; returns the send time and the acknowledgement time,
   * nanoseconds.
   */
  long[] sendMessage() throws IOException {
    String[] words = ask("letter").split(" ");
    return new long[] {Long.parseLong(words[0]), Long.parseLong(words[1])};
  }

  /** Arrival times in nanoseconds, by event number. */
  Map<Long, Long> report() throws IOException {
    Map<Long, Long> reported = new HashMap<>();
    for (String line = ask("report"); !line.isEmpty(); line = line()) {
      String[] words = line.split(" ");
      if (words.length != 2) {
        throw new IOException("a listener's subscription is " + line);
      }
      reported.put(Long.parseLong(words[0]), Long.parseLong(words[1]));
    }
    return reported;
  }

  /** Sends it a signal, as an operator would. */
  void signal(String name) throws IOException, InterruptedException {
    String pid = Long.toString(process.pid());
    if (new ProcessBuilder("kill", "-" + name, pid).start().waitFor() != 0) {
      throw new IOException("process " + pid + " could not be sent " + name);
    }
  }

  private String ask(String line) throws IOException {
    to.write(line + "\n");
    to.flush();
    return line();
  }

  private String line() throws IOException {
    @Nullable String line = from.readLine();
    if (line == null) {
      throw new IOException("a listener's process has ended");
    }
    return line;
  }

  @Override
  public void close() throws InterruptedException {
    process.destroyForcibly();
    boolean unused = process.waitFor(10, TimeUnit.SECONDS);
  }
}
