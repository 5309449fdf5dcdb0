package org.dfra.transport;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.ObjectOutputStream;
import java.io.PrintStream;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.util.Base64;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicInteger;
import net.jini.jeri.ServerEndpoint;
import org.dfra.benchmarks.task.Task;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.call.JeriExporters;
import org.dfra.river.transport.TransportServerEndpoint;

/**
 * A process with a remote object that counts its calls. Arguments: {@code tcp} or {@code local},
 * and an address. It prints "executes" and "half" where a call waits, and lets it go on for a line
 * of input.
 */
public final class CountingTask implements Task {

  /** The remote object. */
  public interface Counter extends Remote {

    /** Counts a call, and returns how many there were before. */
    int count() throws RemoteException;

    /** How many calls were counted. */
    int counted() throws RemoteException;

    /** Returns when the process ends. */
    void block() throws RemoteException;

    /** Returns so many bytes. */
    byte[] bytes(int count) throws RemoteException;

    /** Counts a call, says that it executes, and waits for a line before it returns. */
    int hold() throws RemoteException;

    /** Counts a call that has an argument, whole. */
    int take(Halves argument) throws RemoteException;

    /** Counts a call; half of its result is sent, and the other half after a line. */
    Halves give() throws RemoteException;
  }

  private static final class CounterImpl implements Counter {

    private final AtomicInteger calls = new AtomicInteger();
    private final Semaphore goOn = new Semaphore(0);
    private final PrintStream out;

    CounterImpl(PrintStream out) {
      this.out = out;
    }

    private void await(String where) {
      out.println(where);
      goOn.acquireUninterruptibly();
    }

    @Override
    public int count() {
      return calls.getAndIncrement();
    }

    @Override
    public int counted() {
      return calls.get();
    }

    @Override
    public void block() {
      try {
        new CountDownLatch(1).await();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }

    @Override
    public byte[] bytes(int count) {
      return new byte[count];
    }

    @Override
    public int hold() {
      int before = count();
      await("executes");
      return before;
    }

    @Override
    public int take(Halves argument) {
      return count();
    }

    @Override
    public Halves give() {
      return new Halves(count());
    }
  }

  /** Called by {@link org.dfra.benchmarks.task.TaskMain}. */
  public CountingTask() {}

  @Override
  public void run(String[] args, PrintStream out) throws IOException {
    ServerEndpoint endpoint =
        args[0].equals("tcp")
            ? new TransportServerEndpoint(args[1], 0)
            : Endpoints.withLocalSocket(args[1], 0);
    CounterImpl counter = new CounterImpl(out);
    Halves.pauseBy(() -> counter.await("half"));
    Remote proxy =
        JeriExporters.keepingAlive(endpoint, new DeadlineILFactory(2000L)).export(counter);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream stream = new ObjectOutputStream(bytes)) {
      stream.writeObject(proxy);
    }
    out.println("proxy " + Base64.getEncoder().encodeToString(bytes.toByteArray()));
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
    while (in.readLine() != null) {
      counter.goOn.release();
    }
  }
}
