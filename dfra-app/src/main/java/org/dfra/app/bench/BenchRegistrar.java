package org.dfra.app.bench;

import com.sun.jini.admin.DestroyAdmin;
import com.sun.jini.start.ServiceProxyAccessor;
import java.io.FilterInputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.lang.reflect.Constructor;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.ServerSocket;
import java.net.Socket;
import java.rmi.RemoteException;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import javax.net.ServerSocketFactory;
import net.jini.admin.Administrable;
import net.jini.config.Configuration;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.tcp.TcpServerEndpoint;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.lookup.SuppliedConfiguration;

/** Stock reggie in this virtual machine, which counts the bytes of all calls on it. */
final class BenchRegistrar implements AutoCloseable {

  static final String HOST = "127.0.0.1";

  private final Object reggie;
  private final AtomicLong bytes = new AtomicLong();

  /**
   * @param leaseMillis longest lease it grants, in milliseconds
   */
  BenchRegistrar(long leaseMillis) throws Exception {
    // By its name: the application is compiled without reggie, which only runs beside it.
    Constructor<?> constructor =
        Class.forName("com.sun.jini.reggie.TransientRegistrarImpl")
            .getDeclaredConstructor(
                Configuration.class, Class.forName("com.sun.jini.start.LifeCycle"));
    constructor.setAccessible(true);
    reggie = constructor.newInstance(configuration(leaseMillis), null);
  }

  private Configuration configuration(long leaseMillis) {
    String component = "com.sun.jini.reggie.";
    NetworkInterface[] none = {};
    return new SuppliedConfiguration(
        Map.ofEntries(
            Map.entry(component + "initialMemberGroups", () -> new String[] {"bench"}),
            Map.entry(
                component + "serverExporter",
                () ->
                    new BasicJeriExporter(
                        TcpServerEndpoint.getInstance(HOST, 0, null, new Counting(true)),
                        new DeadlineILFactory(30_000),
                        false,
                        true)),
            Map.entry(component + "serverSocketFactory", () -> new Counting(false)),
            Map.entry(component + "unicastDiscoveryHost", () -> HOST),
            Map.entry(component + "multicastInterfaces", () -> none),
            Map.entry(component + "minMaxServiceLease", () -> leaseMillis),
            Map.entry(component + "minMaxEventLease", () -> leaseMillis),
            // Else a hundred milliseconds more for each service.
            Map.entry(component + "minRenewalInterval", () -> 1L),
            Map.entry("net.jini.discovery.LookupDiscovery.multicastInterfaces", () -> none)));
  }

  ServiceRegistrar registrar() throws RemoteException {
    return (ServiceRegistrar) ((ServiceProxyAccessor) reggie).getServiceProxy();
  }

  String locator() throws IOException {
    return "jini://" + HOST + ":" + registrar().getLocator().getPort();
  }

  /** How many bytes calls on it have cost so far, both ways. */
  long bytes() {
    return bytes.get();
  }

  @Override
  public void close() throws Exception {
    ((DestroyAdmin) ((Administrable) registrar()).getAdmin()).destroy();
  }

  /** Sockets at a free port of the loopback, which count if wanted. */
  private final class Counting extends ServerSocketFactory {
    private final boolean counts;

    Counting(boolean counts) {
      this.counts = counts;
    }

    @Override
    public ServerSocket createServerSocket(int port) throws IOException {
      return new ServerSocket(0, 0, InetAddress.getByName(HOST)) {
        @Override
        public Socket accept() throws IOException {
          Socket socket = new Counted();
          implAccept(socket);
          return socket;
        }
      };
    }

    @Override
    public ServerSocket createServerSocket(int port, int backlog) throws IOException {
      return createServerSocket(port);
    }

    @Override
    public ServerSocket createServerSocket(int port, int backlog, InetAddress address)
        throws IOException {
      return createServerSocket(port);
    }

    private final class Counted extends Socket {
      @Override
      public InputStream getInputStream() throws IOException {
        return new FilterInputStream(super.getInputStream()) {
          @Override
          public int read() throws IOException {
            int read = super.read();
            counted(read < 0 ? -1 : 1);
            return read;
          }

          @Override
          public int read(byte[] to, int from, int length) throws IOException {
            return counted(super.read(to, from, length));
          }
        };
      }

      @Override
      public OutputStream getOutputStream() throws IOException {
        return new FilterOutputStream(super.getOutputStream()) {
          @Override
          public void write(byte[] from, int start, int length) throws IOException {
            out.write(from, start, length);
            counted(length);
          }
        };
      }

      private int counted(int count) {
        if (counts && count > 0) {
          bytes.addAndGet(count);
        }
        return count;
      }
    }
  }
}
