package org.dfra.transport;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectOutputStream;
import java.io.PrintStream;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.util.Base64;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import net.jini.jeri.ServerEndpoint;
import org.dfra.benchmarks.task.Task;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.call.JeriExporters;
import org.dfra.river.transport.TransportServerEndpoint;

/** A process with a remote object that counts its calls. Argument: {@code tcp} or {@code local}. */
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
  }

  private static final class CounterImpl implements Counter {

    private final AtomicInteger calls = new AtomicInteger();

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
  }

  /** Called by {@link org.dfra.benchmarks.task.TaskMain}. */
  public CountingTask() {}

  @Override
  public void run(String[] args, PrintStream out) throws IOException {
    ServerEndpoint endpoint =
        args[0].equals("tcp")
            ? new TransportServerEndpoint("127.0.0.1", 0)
            : Endpoints.withLocalSocket("127.0.0.1", 0);
    Counter counter = new CounterImpl();
    Remote proxy =
        JeriExporters.keepingAlive(endpoint, new DeadlineILFactory(2000L)).export(counter);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream stream = new ObjectOutputStream(bytes)) {
      stream.writeObject(proxy);
    }
    out.println("proxy " + Base64.getEncoder().encodeToString(bytes.toByteArray()));
    while (System.in.read() >= 0) {
      out.println(counter.counted());
    }
  }
}
