package org.dfra.attack.answer;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.lang.reflect.Method;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.Arrays;
import net.jini.export.Exporter;
import net.jini.jeri.BasicJeriExporter;
import org.dfra.benchmarks.attack.CallBytes;
import org.dfra.benchmarks.attack.RawCall;
import org.dfra.benchmarks.attack.RawCall.Answer;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;

/**
 * An object exported as DFRA exports its own, with a method that takes anything and one that takes
 * a text.
 */
final class OpenBox implements AutoCloseable {

  private static final Duration PATIENCE = Duration.ofSeconds(60);

  /** What it offers. */
  public interface Box extends Remote {
    /** How many calls came as far as this. */
    int put(Object value) throws RemoteException;

    /** The same for a text. */
    int label(String text) throws RemoteException;
  }

  private static final class BoxImpl implements Box {

    private int puts; // guarded by this

    @Override
    public synchronized int put(Object value) {
      return ++puts;
    }

    @Override
    public int label(String text) {
      return put(text);
    }
  }

  private final Exporter exporter =
      new BasicJeriExporter(
          Endpoints.tcp("127.0.0.1", 0), new DeadlineILFactory(60_000), false, true);
  private final BoxImpl impl = new BoxImpl(); // JERI holds it weakly
  private final Box proxy;
  private final Method put;
  private final Method label;

  OpenBox() throws RemoteException, NoSuchMethodException {
    proxy = (Box) exporter.export(impl);
    put = Box.class.getMethod("put", Object.class);
    label = Box.class.getMethod("label", String.class);
  }

  Box proxy() {
    return proxy;
  }

  /** The bytes of a call with this argument; what it costs to write them is the attacker's. */
  byte[] call(Object argument) throws IOException {
    return CallBytes.with(put, out -> out.writeObject(argument));
  }

  /** The same for the method that takes a text, whatever the argument is. */
  byte[] labelCall(Object argument) throws IOException {
    return CallBytes.with(label, out -> out.writeObject(argument));
  }

  /** Sends a call and awaits its answer. */
  Answer send(byte[] call) throws IOException, InterruptedException {
    try (RawCall raw = RawCall.to(proxy)) {
      return raw.send(call).finish(PATIENCE);
    }
  }

  /** CPU time that all threads of this process have used, the calling thread left out. */
  static Duration cpu() {
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    long self = Thread.currentThread().getId();
    return Duration.ofNanos(
        Arrays.stream(threads.getAllThreadIds())
            .filter(id -> id != self)
            .map(threads::getThreadCpuTime)
            .filter(nanos -> nanos > 0) // a thread that has ended meanwhile has -1
            .sum());
  }

  @Override
  public void close() {
    exporter.unexport(true);
  }
}
