package org.dfra.benchmarks.micro;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.rmi.NoSuchObjectException;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.server.RMIClientSocketFactory;
import java.rmi.server.UnicastRemoteObject;
import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import net.jini.export.Exporter;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.server.Exporters;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;

/**
 * Remote calls by TCP over the loopback, with both ends in this virtual machine: through the
 * exporter of DFRA's module servers ({@link Exporters#jeri}: JERI with a deadline, a check of all
 * bytes, and filters), and by Java RMI of the JDK, which has none of these. Microseconds.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
public class CallBenchmark {

  /** Number of distances in a scan. */
  static final int BEAMS = 361;

  private static final String HOST = "127.0.0.1";

  private final Ranges served = new Ranges(); // JERI and RMI each have an object of their own
  private final Ranges servedPlainly = new Ranges();
  private final Exporter exporter =
      Exporters.jeri(HOST, DeadlineILFactory.DEFAULT_DEADLINE.toMillis());

  @SuppressWarnings("NullAway.Init") // set by start
  private RangeSource remote;

  @SuppressWarnings("NullAway.Init") // set by start
  private RangeSource plain;

  /** For JMH. */
  public CallBenchmark() {}

  private static final class Ranges implements RangeSource {

    private final double[] scan = new double[BEAMS];

    Ranges() {
      Arrays.setAll(scan, i -> 2 + 10 * Math.abs(Math.sin(0.03 * i))); // a room
    }

    @Override
    public double range() {
      return scan[BEAMS / 2];
    }

    @Override
    public double[] scan() {
      return scan; // it is written to the answer, not handed on
    }
  }

  /**
   * Exports the objects, both on the loopback only.
   *
   * @throws IOException if there is no free port
   */
  @Setup
  public void start() throws IOException {
    InetAddress loopback = InetAddress.getLoopbackAddress();
    remote = (RangeSource) exporter.export(served);
    RMIClientSocketFactory client = (host, port) -> new Socket(loopback, port);
    plain =
        (RangeSource)
            UnicastRemoteObject.exportObject(
                servedPlainly, 0, client, port -> new ServerSocket(port, 0, loopback));
  }

  /**
   * Ends both.
   *
   * @throws NoSuchObjectException if one was not exported
   */
  @TearDown
  public void close() throws NoSuchObjectException {
    boolean unused = exporter.unexport(true);
    unused = UnicastRemoteObject.unexportObject(servedPlainly, true);
  }

  /**
   * A call that returns one number, through DFRA's exporter.
   *
   * @throws RemoteException if the call fails
   */
  @Benchmark
  public double range() throws RemoteException {
    return remote.range();
  }

  /**
   * The same by plain Java RMI.
   *
   * @throws RemoteException if the call fails
   */
  @Benchmark
  public double rangePlain() throws RemoteException {
    return plain.range();
  }

  /**
   * A call that returns {@value #BEAMS} numbers, through DFRA's exporter.
   *
   * @throws RemoteException if the call fails
   */
  @Benchmark
  public double[] scan() throws RemoteException {
    return remote.scan();
  }

  /**
   * The same by plain Java RMI.
   *
   * @throws RemoteException if the call fails
   */
  @Benchmark
  public double[] scanPlain() throws RemoteException {
    return plain.scan();
  }

  /** The remote object of {@link CallBenchmark}: a small and a large result. */
  public interface RangeSource extends Remote {

    /**
     * One distance, metres.
     *
     * @throws RemoteException if the call fails
     */
    double range() throws RemoteException;

    /**
     * The distances of a scan of 180° in steps of 0.5°, metres: 361 of them, as a SICK LMS 200 has.
     *
     * @throws RemoteException if the call fails
     */
    double[] scan() throws RemoteException;
  }
}
