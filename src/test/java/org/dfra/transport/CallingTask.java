package org.dfra.transport;

import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.InputStreamReader;
import java.io.ObjectInputStream;
import java.io.PrintStream;
import java.lang.reflect.Proxy;
import java.rmi.RemoteException;
import java.util.Base64;
import java.util.concurrent.Semaphore;
import net.jini.jeri.BasicInvocationHandler;
import net.jini.jeri.BasicObjectEndpoint;
import org.dfra.benchmarks.task.Task;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.river.call.DeadlineExceededException;
import org.dfra.river.transport.AbortableEndpoint;
import org.dfra.transport.CountingTask.Counter;

/**
 * A process that calls a {@link CountingTask}, whose proxy is its argument. Its input has one
 * command a line:
 *
 * <pre>
 *   count, hold, take, give   makes that call on another thread, and prints "ended OUTCOME ..."
 *   go                        sends the other half of an argument
 *   close                     closes the connections that no call uses
 *   threads                   prints "threads N", those of remote calls
 * </pre>
 */
public final class CallingTask implements Task {

  private final Semaphore goOn = new Semaphore(0);
  private final StallProbe probe = StallProbe.start();

  /** Called by {@link org.dfra.benchmarks.task.TaskMain}. */
  public CallingTask() {}

  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    byte[] bytes = Base64.getDecoder().decode(args[0]);
    Counter counter;
    try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes))) {
      counter = (Counter) in.readObject();
    }
    Halves.pauseBy(
        () -> {
          out.println("half");
          goOn.acquireUninterruptibly();
        });
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
    for (String line; (line = in.readLine()) != null; ) {
      String command = line;
      switch (command) {
        case "go" -> goOn.release();
        case "close" -> endpoint(counter).closeIdleConnections();
        case "threads" -> out.println("threads " + callThreads());
        default -> new Thread(() -> out.println("ended " + outcome(counter, command))).start();
      }
    }
  }

  private static AbortableEndpoint endpoint(Counter counter) {
    BasicInvocationHandler handler = (BasicInvocationHandler) Proxy.getInvocationHandler(counter);
    return (AbortableEndpoint) ((BasicObjectEndpoint) handler.getObjectEndpoint()).getEndpoint();
  }

  private static long callThreads() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(
            each -> each.getName().startsWith("dfra-") && !each.getName().contains("stall-probe"))
        .count();
  }

  /** What became of a call, and the time that it took, as {@link CutNetworkIT} reads it. */
  private String outcome(Counter counter, String command) {
    StallProbe.Stopwatch began = probe.stopwatch();
    String outcome;
    try {
      outcome = "answered-" + call(counter, command);
    } catch (DeadlineExceededException e) {
      outcome = e.mayHaveRun() ? "late-may-have-run" : "late-has-not-run";
    } catch (RemoteException e) {
      outcome = e.toString().replace(' ', '_');
    }
    Timing timing = began.stop();
    return outcome
        + " "
        + timing.took().toNanos()
        + " "
        + timing.stalled().toNanos()
        + " "
        + timing.load()
        + " "
        + timing.stolen().toNanos();
  }

  private static int call(Counter counter, String command) throws RemoteException {
    return switch (command) {
      case "count" -> counter.count();
      case "counted" -> counter.counted();
      case "hold" -> counter.hold();
      case "take" -> counter.take(new Halves(0));
      case "give" -> counter.give().number();
      default -> throw new IllegalArgumentException(command);
    };
  }
}
