package org.dfra.attack.local;

import java.io.PrintStream;
import java.nio.file.Path;
import java.rmi.RemoteException;
import org.dfra.benchmarks.task.Task;
import org.dfra.river.bootstrap.PhoenixProcess;

/** Asks phoenix as a command of {@code ./dfra} does. It prints {@code answered} or the failure. */
public final class AskPhoenix implements Task {

  /**
   * Asks.
   *
   * @param args phoenix's port at 127.0.0.1 and its state folder
   */
  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    PhoenixProcess phoenix =
        new PhoenixProcess("127.0.0.1", Integer.parseInt(args[0]), -1, Path.of(args[1]));
    try {
      phoenix.requireOwnedByUser();
      out.println("answered " + phoenix.admin().groupStatus().size());
    } catch (RemoteException e) {
      out.println("failed " + e.getMessage());
    }
  }
}
