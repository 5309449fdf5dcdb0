package org.dfra.activation;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import javax.net.ServerSocketFactory;
import net.jini.jeri.BasicILFactory;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.tcp.TcpServerEndpoint;

/** What any River service does first: exports an object by JERI. Then calls it once. */
public final class JeriExportMain {

  /** Printed when the call came back. */
  static final String DONE = "JERI called; ActivationID is of the loader ";

  private JeriExportMain() {}

  /** What is called. */
  public interface Echo extends Remote {
    String echo(String text) throws RemoteException;
  }

  private static final class EchoImpl implements Echo {
    @Override
    public String echo(String text) {
      return text;
    }
  }

  /** Server sockets on the loopback address. */
  static final class OnLoopback extends ServerSocketFactory {
    @Override
    public ServerSocket createServerSocket(int port) throws IOException {
      return createServerSocket(port, 50);
    }

    @Override
    public ServerSocket createServerSocket(int port, int backlog) throws IOException {
      return createServerSocket(port, backlog, InetAddress.getLoopbackAddress());
    }

    @Override
    public ServerSocket createServerSocket(int port, int backlog, InetAddress address)
        throws IOException {
      return new ServerSocket(port, backlog, address);
    }
  }

  public static void main(String[] args) throws Exception {
    EchoImpl impl = new EchoImpl();
    BasicJeriExporter exporter =
        new BasicJeriExporter(
            TcpServerEndpoint.getInstance("127.0.0.1", 0, null, new OnLoopback()),
            new BasicILFactory());
    Echo proxy = (Echo) exporter.export(impl);
    try {
      System.out.println(proxy.echo(DONE) + ActivationID.class.getClassLoader());
    } finally {
      exporter.unexport(true);
    }
  }
}
