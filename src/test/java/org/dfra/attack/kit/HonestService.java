package org.dfra.attack.kit;

import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.server.ServerNotActiveException;
import java.util.concurrent.CountDownLatch;
import net.jini.export.Exporter;
import net.jini.export.ServerContext;
import net.jini.io.context.ClientHost;
import net.jini.jeri.BasicJeriExporter;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;

/** An object exported as DFRA exports its own, for attacks on the transport itself. */
final class HonestService implements AutoCloseable {

  /** What it offers. */
  public interface Adder extends Remote {
    /** The address from which the caller connected. */
    String client() throws RemoteException;

    /** The sum. */
    int add(int a, int b) throws RemoteException;

    /** How many calls of {@link #add} there were. */
    int additions() throws RemoteException;

    /** Returns when the object is no longer exported. */
    void hang() throws RemoteException;
  }

  private final Exporter exporter;
  private final AdderImpl impl = new AdderImpl(); // JERI holds it weakly
  private final Adder proxy;

  /**
   * Exports it.
   *
   * @param host the address to listen on
   */
  HonestService(String host) throws RemoteException {
    exporter = new BasicJeriExporter(Endpoints.tcp(host, 0), new DeadlineILFactory(), false, true);
    proxy = (Adder) exporter.export(impl);
  }

  Adder proxy() {
    return proxy;
  }

  @Override
  public void close() {
    exporter.unexport(true);
    impl.ended.countDown();
  }

  private static final class AdderImpl implements Adder {

    private final CountDownLatch ended = new CountDownLatch(1);
    private int additions; // guarded by this

    @Override
    public String client() throws RemoteException {
      try {
        ClientHost host = (ClientHost) ServerContext.getServerContextElement(ClientHost.class);
        return host.getClientHost().getHostAddress();
      } catch (ServerNotActiveException e) {
        throw new RemoteException("not called remotely", e);
      }
    }

    @Override
    public synchronized int add(int a, int b) {
      additions++;
      return a + b;
    }

    @Override
    public synchronized int additions() {
      return additions;
    }

    @Override
    public void hang() throws RemoteException {
      try {
        ended.await();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw new RemoteException("interrupted while it waited for the end", e);
      }
    }
  }
}
