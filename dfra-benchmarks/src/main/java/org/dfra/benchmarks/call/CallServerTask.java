package org.dfra.benchmarks.call;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.file.Path;
import org.dfra.benchmarks.task.Task;

/**
 * The server's process. Arguments: the {@link CallPeer} and an empty folder. It prints {@code
 * address ADDRESS}, and to each line of its input how many threads have ended in it: {@code ended
 * NUMBER}. It ends with its input.
 */
public final class CallServerTask implements Task {

  /** For {@link org.dfra.benchmarks.task.TaskProcess}. */
  public CallServerTask() {}

  @Override
  public void run(String[] args, PrintStream out) throws IOException {
    CallTransport transport = CallPeer.valueOf(args[0]).transport();
    transport.prepare();
    out.println("address " + transport.serve(Path.of(args[1])));
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
    while (in.readLine() != null) {
      out.println("ended " + EndedThreads.count());
    }
  }
}
