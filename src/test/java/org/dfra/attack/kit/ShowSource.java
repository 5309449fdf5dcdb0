package org.dfra.attack.kit;

import java.io.PrintStream;
import java.net.Socket;
import org.dfra.benchmarks.attack.SourceSockets;
import org.dfra.benchmarks.task.Task;

/** Connects from an address to a server, and prints from where it did. */
public final class ShowSource implements Task {

  /** As every task is made. */
  public ShowSource() {}

  /** Arguments: the source address, and the server's host and port. */
  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    int port = Integer.parseInt(args[2]);
    try (Socket socket = SourceSockets.from(args[0]).createSocket(args[1], port)) {
      out.println("connected from " + socket.getLocalAddress().getHostAddress());
    }
  }
}
