package org.dfra.river.transport;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.List;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.jeri.RequestDispatcher;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.transport.local.ComputerId;
import org.dfra.river.transport.local.LocalSocket;
import org.dfra.river.transport.local.SocketFolder;
import org.jspecify.annotations.Nullable;

/** One port that is listened on, with its local socket; its requests have one dispatcher. */
final class ServerPort {

  private static final System.Logger LOG = System.getLogger(ServerPort.class.getName());

  /** Connections that the operating system accepts for a process that is busy. */
  private static final int BACKLOG = 1024;

  private final Uuid id;
  private final InetAddress host;
  private final RequestDispatcher dispatcher;
  private final @Nullable ChannelIdentity identity;
  private final ServerSocketChannel tcp;
  private final @Nullable ServerSocketChannel unix;
  private final @Nullable LocalSocket local;
  private volatile boolean closed;

  private ServerPort(
      Uuid id,
      InetAddress host,
      RequestDispatcher dispatcher,
      @Nullable ChannelIdentity identity,
      ServerSocketChannel tcp,
      @Nullable ServerSocketChannel unix)
      throws IOException {
    this.id = id;
    this.host = host;
    this.dispatcher = dispatcher;
    this.identity = identity;
    this.tcp = tcp;
    this.unix = unix;
    this.local = unix == null ? null : new LocalSocket(ComputerId.OWN, SocketFolder.path(unix), id);
  }

  /**
   * Begins to listen.
   *
   * @param host the address of this computer to listen on
   * @param port TCP port, or 0 for one that the system chooses
   * @param isLocalToo whether to listen on a Unix-domain socket too
   * @param identity encrypts all connections; null for none
   * @throws IOException if the port is taken or the address is none of this computer
   */
  static ServerPort open(
      InetAddress host,
      int port,
      boolean isLocalToo,
      RequestDispatcher dispatcher,
      @Nullable ChannelIdentity identity)
      throws IOException {
    ServerSocketChannel tcp = ServerSocketChannel.open();
    @Nullable ServerSocketChannel unix = null;
    boolean done = false;
    try {
      tcp.bind(new InetSocketAddress(host, port), BACKLOG);
      Uuid id = UuidFactory.generate();
      unix = isLocalToo ? SocketFolder.listen(id, BACKLOG) : null;
      ServerPort opened = new ServerPort(id, host, dispatcher, identity, tcp, unix);
      tcp.configureBlocking(false);
      if (unix != null) {
        unix.configureBlocking(false);
      }
      ConnectionSelector.instance().listen(opened);
      done = true;
      return opened;
    } finally {
      if (!done) {
        close(tcp);
        if (unix != null) {
          close(unix);
        }
      }
    }
  }

  /** The TCP port. */
  int port() {
    return tcp.socket().getLocalPort();
  }

  /** The local socket, if there is one. */
  @Nullable LocalSocket local() {
    return local;
  }

  /** Identifies this server. */
  Uuid id() {
    return id;
  }

  /** Encrypts all connections; null if none is encrypted. */
  @Nullable ChannelIdentity identity() {
    return identity;
  }

  RequestDispatcher dispatcher() {
    return dispatcher;
  }

  /** What to accept connections from. */
  List<ServerSocketChannel> channels() {
    return unix == null ? List.of(tcp) : List.of(tcp, unix);
  }

  /** The link of an accepted connection. */
  Link link(ServerSocketChannel from, SocketChannel accepted) throws IOException {
    return from == tcp ? SocketLink.tcp(accepted) : SocketLink.unix(accepted, host);
  }

  /** Whether no more requests are dispatched. */
  boolean isClosed() {
    return closed;
  }

  /** Accepts no more connections and requests. Calls in progress are answered. */
  void close() {
    closed = true;
    channels().forEach(ServerPort::close);
    if (local != null) {
      SocketFolder.delete(local.path());
    }
    ConnectionSelector.instance().closeConnections(this);
  }

  private static void close(ServerSocketChannel channel) {
    try {
      channel.close();
    } catch (IOException e) {
      LOG.log(Level.DEBUG, "A port was not closed in order.", e);
    }
  }
}
