package org.dfra.phoenix;

import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.rmi.MarshalledObject;
import java.util.ArrayList;
import java.util.List;
import net.jini.export.Exporter;
import net.jini.jeri.BasicJeriExporter;
import org.dfra.river.bootstrap.JvmCommand;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;

/**
 * A beacon in a process of its own, without phoenix; {@link #start} starts it and brings its proxy.
 */
final class RemoteBeacon implements AutoCloseable {

  final Process process;
  final Beacon proxy;

  private RemoteBeacon(Process process, Beacon proxy) {
    this.process = process;
    this.proxy = proxy;
  }

  /** Starts the process; its calls have a deadline of 2 s. */
  @SuppressWarnings("unchecked")
  static RemoteBeacon start() throws Exception {
    List<String> command = new ArrayList<>(List.of(JvmCommand.java()));
    command.addAll(JvmCommand.options());
    command.add("-Xmx64m");
    command.add(RemoteBeacon.class.getName());
    Process process =
        new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start();
    try {
      ObjectInputStream in = new ObjectInputStream(process.getInputStream());
      return new RemoteBeacon(process, ((MarshalledObject<Beacon>) in.readObject()).get());
    } catch (Exception e) {
      process.destroyForcibly();
      throw e;
    }
  }

  /** Serves until its standard input ends. */
  public static void main(String[] args) throws Exception {
    Exporter exporter =
        new BasicJeriExporter(
            Endpoints.tcp("127.0.0.1", 0), new DeadlineILFactory(2000L), false, true);
    BeaconServer server = new BeaconServer();
    ObjectOutputStream out = new ObjectOutputStream(System.out);
    out.writeObject(new MarshalledObject<>(exporter.export(server)));
    out.flush();
    System.in.read(new byte[1]);
    exporter.unexport(true);
    System.exit(0);
  }

  void signal(String name) throws Exception {
    PhoenixFixture.signal(name, process.pid());
  }

  @Override
  public void close() throws Exception {
    process.destroyForcibly().waitFor();
  }

  /** What it serves. */
  static final class BeaconServer implements Beacon {
    private final java.util.concurrent.atomic.AtomicInteger counter =
        new java.util.concurrent.atomic.AtomicInteger();

    @Override
    public long pid() {
      return ProcessHandle.current().pid();
    }

    @Override
    public int instances() {
      return 1;
    }

    @Override
    public int count() {
      return counter.incrementAndGet();
    }

    @Override
    public void sleep(long millis) {
      try {
        new java.util.concurrent.CountDownLatch(1)
            .await(millis, java.util.concurrent.TimeUnit.MILLISECONDS);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }

    @Override
    public int length(byte[] load) {
      return load.length;
    }

    @Override
    public void deactivate() {}

    @Override
    public void print(String line) {}
  }
}
