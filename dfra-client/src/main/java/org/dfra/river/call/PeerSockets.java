package org.dfra.river.call;

import java.io.IOException;
import java.io.Serializable;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketAddress;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import javax.net.SocketFactory;
import net.jini.jeri.tcp.TcpEndpoint;
import org.dfra.river.transport.CallInFlight;
import org.jspecify.annotations.Nullable;

/**
 * A client's sockets to servers; broken connections are closed.
 *
 * <p>TCP retransmits unacknowledged data at growing intervals, up to minutes. After a robot was out
 * of radio range for a minute, an old connection may need another minute to recover, and JERI sends
 * every call over it as long as it is open. So when a call has exceeded its deadline, its server's
 * host is {@linkplain #probeAsync probed} with a new connection. If the host does not accept it,
 * all connections to that server are closed, and the next call opens a new one. A host also accepts
 * it for a process that is slow or suspended, so calls that such a process may still answer are not
 * aborted.
 *
 * <p>Connecting itself has the usual deadline of a call.
 */
final class PeerSockets extends SocketFactory implements Serializable {

  private static final long serialVersionUID = 1L;

  private static final System.Logger LOG = System.getLogger(PeerSockets.class.getName());

  private static final int CONNECT_MILLIS =
      Math.toIntExact(DeadlineILFactory.DEFAULT_DEADLINE.toMillis());
  private static final int PROBE_TIMEOUT_MILLIS = 1000;

  /** Probes that a suspended process does not accept accumulate in the operating system. */
  private static final long PROBE_INTERVAL_NANOS = TimeUnit.SECONDS.toNanos(5);

  private static final Set<Connected> OPEN = ConcurrentHashMap.newKeySet();
  private static final ConcurrentHashMap<TcpEndpoint, Long> LAST_PROBES = new ConcurrentHashMap<>();

  /** Probes a server's host in the background; see the class. */
  static void probeAsync(TcpEndpoint server) {
    if (isDue(server)) {
      CallThreads.run(new FutureTask<>(() -> connectOrCloseAll(server), null));
    }
  }

  /** Probes on this thread, for at most {@value #PROBE_TIMEOUT_MILLIS} ms. */
  static void probe(TcpEndpoint server) {
    if (isDue(server)) {
      connectOrCloseAll(server);
    }
  }

  private static boolean isDue(TcpEndpoint server) {
    if (!(server.getSocketFactory() instanceof PeerSockets)) {
      return false;
    }
    long now = System.nanoTime();
    LAST_PROBES.values().removeIf(at -> now - at > PROBE_INTERVAL_NANOS);
    return LAST_PROBES.putIfAbsent(server, now) == null;
  }

  private static void connectOrCloseAll(TcpEndpoint server) {
    try (Socket socket = new Socket()) {
      socket.connect(
          new InetSocketAddress(server.getHost(), server.getPort()), PROBE_TIMEOUT_MILLIS);
    } catch (IOException e) {
      List<Connected> dead = OPEN.stream().filter(each -> each.isTo(server)).toList();
      dead.forEach(Connected::abandon);
      if (!dead.isEmpty()) {
        String closed = dead.size() == 1 ? "1 connection is" : dead.size() + " connections are";
        LOG.log(
            Level.INFO,
            () ->
                server.getHost()
                    + ":"
                    + server.getPort()
                    + " is out of reach ("
                    + e.getMessage()
                    + "); "
                    + closed
                    + " closed; new ones open when it is back.");
      }
    }
  }

  @Override
  public Socket createSocket() {
    return new Connected();
  }

  @Override
  public Socket createSocket(String host, int port) throws IOException {
    return connected(new InetSocketAddress(host, port), null);
  }

  @Override
  public Socket createSocket(InetAddress host, int port) throws IOException {
    return connected(new InetSocketAddress(host, port), null);
  }

  @Override
  public Socket createSocket(String host, int port, InetAddress from, int fromPort)
      throws IOException {
    return connected(new InetSocketAddress(host, port), new InetSocketAddress(from, fromPort));
  }

  @Override
  public Socket createSocket(InetAddress host, int port, InetAddress from, int fromPort)
      throws IOException {
    return connected(new InetSocketAddress(host, port), new InetSocketAddress(from, fromPort));
  }

  private static Socket connected(InetSocketAddress to, @Nullable InetSocketAddress from)
      throws IOException {
    Connected socket = new Connected();
    try {
      socket.bind(from);
      socket.connect(to);
      return socket;
    } catch (IOException e) {
      socket.abandon();
      throw e;
    }
  }

  /** All instances are equal, since endpoints are compared by their factories. */
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof PeerSockets;
  }

  @Override
  public int hashCode() {
    return PeerSockets.class.hashCode();
  }

  @Override
  public String toString() {
    return "PeerSockets";
  }

  /** One connection. */
  private static final class Connected extends Socket {

    private volatile @Nullable InetSocketAddress peer;

    @Override
    public void connect(SocketAddress to) throws IOException {
      connect(to, 0);
    }

    @Override
    public void connect(SocketAddress to, int millis) throws IOException {
      CallInFlight.attachConnection(this);
      super.connect(to, millis == 0 ? CONNECT_MILLIS : Math.min(millis, CONNECT_MILLIS));
      peer = (InetSocketAddress) to;
      OPEN.add(this);
    }

    boolean isTo(TcpEndpoint server) {
      InetSocketAddress known = peer;
      return known != null
          && known.getPort() == server.getPort()
          && (known.getHostString().equals(server.getHost())
              || known.getAddress().getHostAddress().equals(server.getHost()));
    }

    void abandon() {
      try {
        close();
      } catch (IOException e) {
        LOG.log(Level.DEBUG, "A connection to " + peer + " was not closed in order.", e);
      }
    }

    @Override
    public void close() throws IOException {
      OPEN.remove(this);
      super.close();
    }
  }
}
