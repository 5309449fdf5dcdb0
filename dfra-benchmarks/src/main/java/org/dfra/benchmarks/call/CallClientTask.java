package org.dfra.benchmarks.call;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.util.Arrays;
import java.util.stream.Collectors;
import org.dfra.benchmarks.task.Task;

/**
 * The client's process. Argument: the {@link CallPeer}. It answers each line of its input with one
 * line:
 *
 * <ul>
 *   <li>{@code connect ADDRESS} with {@code connected};
 *   <li>{@code echo NUMBER} with {@code answer} and the server's answer;
 *   <li>{@code values} with {@code answer} and the server's doubles;
 *   <li>{@code load KIND CALLS} with {@code done}, after the calls;
 *   <li>{@code times} with {@code times} and {@link CallTimes#line}, of all calls since the last
 *       such command;
 *   <li>{@code threads} with {@code ended} and how many threads have ended in it.
 * </ul>
 *
 * <p>It ends with its input, and fails with the first call that fails or gives a wrong answer.
 */
public final class CallClientTask implements Task {

  /** For {@link org.dfra.benchmarks.task.TaskProcess}. */
  public CallClientTask() {}

  @Override
  public void run(String[] args, PrintStream out) throws IOException, InterruptedException {
    CallTransport transport = CallPeer.valueOf(args[0]).transport();
    transport.prepare();
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
    String first = in.readLine();
    if (first == null) {
      return;
    }
    CallTransport.Connection connection = transport.connect(first.substring("connect ".length()));
    out.println("connected");
    try (CallLoad load = new CallLoad(connection);
        Caller caller = connection.caller()) {
      for (String line; (line = in.readLine()) != null; ) {
        out.println(answer(line.split(" ", -1), load, caller));
      }
    }
  }

  private static String answer(String[] words, CallLoad load, Caller caller)
      throws IOException, InterruptedException {
    return switch (words[0]) {
      case "echo" -> "answer " + caller.echo(Long.parseLong(words[1]));
      case "values" ->
          "answer "
              + Arrays.stream(caller.values())
                  .mapToObj(Double::toString)
                  .collect(Collectors.joining(" "));
      case "load" -> {
        load.run(CallKind.ofCommand(words[1]), Integer.parseInt(words[2]));
        yield "done";
      }
      case "times" -> "times " + load.times().line();
      case "threads" -> "ended " + EndedThreads.count();
      default -> throw new IOException("there is no command " + words[0]);
    };
  }
}
