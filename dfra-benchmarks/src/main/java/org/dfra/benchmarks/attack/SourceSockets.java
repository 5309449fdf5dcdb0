package org.dfra.benchmarks.attack;

import java.io.IOException;
import java.io.Serializable;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketAddress;
import java.util.concurrent.atomic.AtomicInteger;
import javax.net.ServerSocketFactory;
import javax.net.SocketFactory;
import net.jini.jeri.Endpoint;
import net.jini.jeri.ServerEndpoint;
import net.jini.jeri.tcp.TcpServerEndpoint;
import org.dfra.river.call.Endpoints;
import org.dfra.river.transport.AbortableEndpoint;
import org.dfra.river.transport.SourceBoundEndpoint;
import org.jspecify.annotations.Nullable;

/**
 * Sockets whose connections leave from one address of this computer. Linux assigns all of
 * 127.0.0.0/8 to the loopback, so that a process can appear to a server as another computer.
 *
 * <p>JERI shares a connection between calls to equal endpoints, which have equal socket factories.
 * Factories of {@link #from} with the same address are equal; a factory of {@link #unshared} equals
 * no other, so that its calls use separate connections.
 */
public final class SourceSockets extends SocketFactory implements Serializable {

  private static final long serialVersionUID = 1L;

  private static final AtomicInteger LAST = new AtomicInteger();

  private final String source;
  private final int number; // ID of the connection group; 0 is the group of from

  private SourceSockets(String source, int number) {
    this.source = source;
    this.number = number;
  }

  /**
   * Sockets that connect from an address.
   *
   * @param source one of this computer's addresses; otherwise binding a socket fails
   */
  public static SourceSockets from(String source) {
    return new SourceSockets(source, 0);
  }

  /** Sockets from the same address that share no connection with others. */
  public SourceSockets unshared() {
    return new SourceSockets(source, LAST.incrementAndGet());
  }

  /** The address from which they connect. */
  public String source() {
    return source;
  }

  /** The same endpoint, called from the address. */
  Endpoint bound(AbortableEndpoint endpoint) {
    return new SourceBoundEndpoint(endpoint.host(), endpoint.port(), source, number);
  }

  /** Server sockets that listen on the address only. */
  public ServerSocketFactory serverSockets() {
    return Endpoints.serverSocketFactory(source);
  }

  /**
   * A stock endpoint to export the attacker's own objects on. It listens on the address, at a port
   * that the system chooses.
   */
  public ServerEndpoint serverEndpoint() {
    return TcpServerEndpoint.getInstance(source, 0, null, serverSockets());
  }

  @Override
  public Socket createSocket() {
    return new FromSource(source);
  }

  @Override
  public Socket createSocket(String host, int port) throws IOException {
    return connected(new InetSocketAddress(host, port));
  }

  @Override
  public Socket createSocket(InetAddress host, int port) throws IOException {
    return connected(new InetSocketAddress(host, port));
  }

  /** Connects from the address of this factory, whatever the caller requests. */
  @Override
  public Socket createSocket(String host, int port, InetAddress from, int fromPort)
      throws IOException {
    return createSocket(host, port);
  }

  /** Connects from the address of this factory, whatever the caller requests. */
  @Override
  public Socket createSocket(InetAddress host, int port, InetAddress from, int fromPort)
      throws IOException {
    return createSocket(host, port);
  }

  private Socket connected(InetSocketAddress to) throws IOException {
    Socket socket = createSocket();
    try {
      socket.connect(to);
      return socket;
    } catch (IOException e) {
      socket.close();
      throw e;
    }
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof SourceSockets sockets
        && sockets.source.equals(source)
        && sockets.number == number;
  }

  @Override
  public int hashCode() {
    return 31 * source.hashCode() + number;
  }

  @Override
  public String toString() {
    return "SourceSockets[" + source + "#" + number + "]";
  }

  /** A socket that is bound to the address before it connects. */
  private static final class FromSource extends Socket {

    private final String source;

    FromSource(String source) {
      this.source = source;
    }

    @Override
    public void connect(SocketAddress to) throws IOException {
      connect(to, 0);
    }

    @Override
    public void connect(SocketAddress to, int millis) throws IOException {
      if (!isBound()) {
        bind(new InetSocketAddress(InetAddress.getByName(source), 0));
      }
      super.connect(to, millis);
    }
  }
}
