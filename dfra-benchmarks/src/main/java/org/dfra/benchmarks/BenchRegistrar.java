package org.dfra.benchmarks;

import java.io.FilterInputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import javax.net.ServerSocketFactory;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.jeri.tcp.TcpServerEndpoint;
import org.dfra.benchmarks.event.BenchActivation;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.JeriExporters;

/** River's Reggie in this JVM; it counts the bytes of all calls. */
final class BenchRegistrar implements AutoCloseable {

  static final String HOST = BenchActivation.HOST;

  private final EmbeddedRegistrar reggie;
  private final AtomicLong bytes = new AtomicLong();

  /**
   * @param leaseMillis longest lease that it grants, milliseconds
   */
  BenchRegistrar(long leaseMillis) throws IOException {
    this.reggie =
        new EmbeddedRegistrar(
                HOST,
                0,
                List.of("bench"),
                Duration.ofMillis(leaseMillis),
                Map.of(
                    "serverExporter",
                    () ->
                        JeriExporters.keepingAlive(
                            TcpServerEndpoint.getInstance(HOST, 0, null, new Counting()),
                            new DeadlineILFactory(30_000)),
                    "minRenewalInterval",
                    () -> 1L)) // the default adds 100 ms for each service
            .start();
  }

  ServiceRegistrar registrar() {
    return reggie.registrar();
  }

  String locator() {
    return reggie.locator();
  }

  /** Number of bytes of all calls so far, in both directions. */
  long bytes() {
    return bytes.get();
  }

  @Override
  public void close() throws IOException {
    reggie.close();
  }

  /** Byte-counting sockets at a free port of the loopback. */
  private final class Counting extends ServerSocketFactory {
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
        if (count > 0) {
          bytes.addAndGet(count);
        }
        return count;
      }
    }
  }
}
