package org.dfra.river.transport;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.Closeable;
import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardProtocolFamily;
import java.net.StandardSocketOptions;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import javax.net.ssl.SSLException;
import net.jini.id.Uuid;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.transport.local.LocalSocket;
import org.dfra.text.PrintableText;
import org.jspecify.annotations.Nullable;

/**
 * The connections of this virtual machine to one server that no call uses at the moment.
 *
 * <p>The one that was used last is used first, so that the others become old: after {@value
 * #PAUSE_MILLIS} ms the server is informed, and after {@value #IDLE_SECONDS} s they are closed.
 * {@link CallWatchdog} sees to that.
 */
final class ClientConnections {

  private static final System.Logger LOG = System.getLogger(ClientConnections.class.getName());

  private static final long PAUSE_MILLIS = 300;
  private static final long IDLE_SECONDS = 30;
  private static final long PAUSE_NANOS = TimeUnit.MILLISECONDS.toNanos(PAUSE_MILLIS);
  private static final long IDLE_NANOS = TimeUnit.SECONDS.toNanos(IDLE_SECONDS);

  /** Further connections are closed after their call. */
  private static final int MAX_IDLE = 32;

  private static final ConcurrentHashMap<Key, ClientConnections> ALL = new ConcurrentHashMap<>();

  private final Key key;

  @GuardedBy("this")
  private final ArrayDeque<ClientConnection> idle = new ArrayDeque<>(); // first: used last

  @GuardedBy("this")
  private boolean removed; // from the table; another list has its place

  private ClientConnections(Key key) {
    this.key = key;
  }

  /**
   * Which calls share connections. With the local socket: who sent an endpoint may have put a
   * strange socket into it. The hash code is computed once, since each call needs it.
   */
  static final class Key {

    private final TransportEndpoint server;
    private final @Nullable LocalSocket local;
    private final @Nullable ChannelIdentity identity;
    private final @Nullable InetAddress source;
    private final int group;
    private final int hash;

    Key(
        TransportEndpoint server,
        @Nullable LocalSocket local,
        @Nullable ChannelIdentity identity,
        @Nullable InetAddress source,
        int group) {
      this.server = server;
      this.local = local;
      this.identity = identity;
      this.source = source;
      this.group = group;
      this.hash = Objects.hash(server, local, source, group);
    }

    @Override
    public boolean equals(@Nullable Object other) {
      return this == other
          || (other instanceof Key key
              && key.hash == hash
              && key.server.equals(server)
              && Objects.equals(key.local, local)
              && key.identity == identity
              && Objects.equals(key.source, source)
              && key.group == group);
    }

    @Override
    public int hashCode() {
      return hash;
    }
  }

  /** The connections to a server. */
  static ClientConnections to(TransportEndpoint server) {
    return of(server.key());
  }

  /** One group of the TCP connections to a server from one address of this computer. */
  static ClientConnections to(TransportEndpoint server, InetAddress source, int group) {
    return of(new Key(server, null, server.identity(), source, group));
  }

  private static ClientConnections of(Key key) {
    @Nullable ClientConnections known = ALL.get(key);
    return known == null ? ALL.computeIfAbsent(key, ClientConnections::new) : known;
  }

  /** Who this end is; null if the calls to this server are not encrypted. */
  @Nullable ChannelIdentity identity() {
    return key.identity;
  }

  /** A connection on which a request may be sent; null if a new one is needed. */
  @Nullable ClientConnection takeIdle() {
    while (true) {
      @Nullable ClientConnection last;
      synchronized (this) {
        last = idle.pollFirst();
      }
      if (last == null || (!last.isRevoked() && last.isOpen(System.nanoTime()))) {
        return last;
      }
      last.closeIdle();
    }
  }

  /** Keeps a connection for the next call. */
  void giveBack(ClientConnection connection) {
    long now = System.nanoTime();
    connection.setIdle(now);
    @Nullable ClientConnection surplus = null;
    synchronized (this) {
      if (!removed) {
        idle.addFirst(connection);
        if (idle.size() > MAX_IDLE) {
          surplus = idle.pollLast();
        }
        if (surplus == null) {
          CallWatchdog.wakeBy(now + PAUSE_NANOS);
          return;
        }
      }
    }
    if (surplus == null) {
      of(key).giveBack(connection);
    } else {
      surplus.closeIdle();
    }
  }

  /** Closes all of them. */
  void closeIdle() {
    List<ClientConnection> closing;
    synchronized (this) {
      closing = new ArrayList<>(idle);
      idle.clear();
    }
    closing.forEach(ClientConnection::closeIdle);
  }

  /**
   * Pauses and closes the connections of all servers that are due.
   *
   * @param now {@link System#nanoTime()}
   * @return when the next one is due, in nanoseconds from now; {@link Long#MAX_VALUE} if none is
   */
  static long tendAll(long now) {
    long next = Long.MAX_VALUE;
    for (ClientConnections each : ALL.values()) {
      next = Math.min(next, each.tend(now));
    }
    return next;
  }

  private long tend(long now) {
    List<ClientConnection> old = new ArrayList<>();
    long next = Long.MAX_VALUE;
    synchronized (this) {
      for (Iterator<ClientConnection> all = idle.iterator(); all.hasNext(); ) {
        ClientConnection each = all.next();
        long idleNanos = each.idleNanos(now);
        boolean isOld = idleNanos >= IDLE_NANOS;
        if (!isOld && !each.isPaused() && idleNanos >= PAUSE_NANOS) {
          isOld = !paused(each);
        }
        if (isOld) {
          all.remove();
          old.add(each);
        } else {
          next = Math.min(next, (each.isPaused() ? IDLE_NANOS : PAUSE_NANOS) - idleNanos);
        }
      }
      if (idle.isEmpty()) {
        removed = true;
        ALL.remove(key, this);
      }
    }
    old.forEach(ClientConnection::closeIdle);
    return next;
  }

  private static boolean paused(ClientConnection connection) {
    try {
      connection.pause();
      return true;
    } catch (IOException e) {
      LOG.log(Level.DEBUG, "An idle connection had ended.", e);
      return false;
    }
  }

  /**
   * Opens a connection. The current call's abandonment closes it meanwhile.
   *
   * @throws IOException if the server cannot be reached; nothing was sent that it would execute
   */
  ClientConnection open() throws IOException {
    @Nullable LocalSocket local = key.source == null ? key.server.usableLocalSocket() : null;
    if (local != null) {
      @Nullable ClientConnection connection = openLocally(local);
      if (connection != null) {
        return connection;
      }
    }
    InetAddress address = HostAddresses.resolve(key.server.host());
    SocketChannel channel = SocketChannel.open();
    return opened(
        channel,
        Greeting.ANY_SERVER,
        () -> {
          if (key.source != null) {
            channel.bind(new InetSocketAddress(key.source, 0));
          }
          // Closing discards what was not sent. Else the operating system would send the request
          // of a call that was given up as soon as the network is back, and it would be executed.
          channel.setOption(StandardSocketOptions.SO_LINGER, 0);
          channel.connect(new InetSocketAddress(address, key.server.port()));
          if (channel.getRemoteAddress().equals(channel.getLocalAddress())) {
            // Nobody listens, and the operating system chose the server's port for this end.
            throw new ConnectException("Connection refused");
          }
          return SocketLink.tcp(channel);
        });
  }

  /**
   * Opens a connection by the Unix-domain socket.
   *
   * @return null if TCP is to be tried: the socket is not there, may not be opened, or belongs to
   *     another user or server
   */
  private @Nullable ClientConnection openLocally(LocalSocket local) throws IOException {
    SocketChannel channel = SocketChannel.open(StandardProtocolFamily.UNIX);
    try {
      return opened(
          channel,
          local.server(),
          () -> {
            channel.connect(UnixDomainSocketAddress.of(local.path()));
            return SocketLink.unixToOwnUser(channel, HostAddresses.resolve(key.server.host()));
          });
    } catch (IOException e) {
      CallInFlight.checkNotAbandoned(e);
      LOG.log(Level.DEBUG, () -> "No local connection to " + key.server + ", so TCP: " + e);
      return null;
    }
  }

  private interface Connecting {
    Link connect() throws IOException;
  }

  private ClientConnection opened(Closeable channel, Uuid server, Connecting connecting)
      throws IOException {
    Closeable opened = channel;
    boolean done = false;
    try {
      CallInFlight.attachAttempt(channel);
      Link link = connecting.connect();
      opened = link;
      CallInFlight.attachConnection(link); // to close the channel alone may end no wait
      greet(link, server);
      Link ready = encrypted(link);
      done = true;
      return new ClientConnection(ready);
    } finally {
      if (!done) {
        opened.close();
      }
    }
  }

  private Link encrypted(Link link) throws IOException {
    @Nullable ChannelIdentity identity = key.identity;
    if (identity == null) {
      return link;
    }
    TlsLink encrypted = TlsLink.client(link, identity, key.server.host(), key.server.port());
    try {
      encrypted.handshake();
    } catch (SSLException e) {
      throw new ServerNotAcceptedException(
          PrintableText.line(
              key.server + " and " + identity + " do not accept each other: " + e.getMessage()),
          e);
    }
    return encrypted;
  }

  /**
   * The server has ended the handshake when this end had finished it: it does not believe this
   * end's certificate. A member whose certificate has expired is believed to have been one.
   */
  ServerNotAcceptedException notAccepted(SSLException alert) {
    return new ServerNotAcceptedException(
        PrintableText.line(
            key.server
                + " does not accept the certificate of "
                + key.identity
                + ", and has not executed the call: it was revoked, is not valid yet by that"
                + " computer's clock, or is of another team ("
                + alert.getMessage()
                + ")"),
        alert);
  }

  private void greet(Link link, Uuid server) throws IOException {
    ByteBuffer bytes = ByteBuffer.allocate(Greeting.CLIENT_BYTES);
    Greeting.putClient(bytes, server, key.identity != null, CallInFlight.isCurrentStop());
    link.write(bytes.flip());
    bytes.clear().limit(Greeting.SERVER_BYTES);
    while (bytes.hasRemaining()) {
      if (link.read(bytes) < 0) {
        throw MessageInput.ended();
      }
    }
    Greeting.Answer answer = Greeting.readServer(bytes.flip());
    if (answer != Greeting.Answer.WELCOME) {
      String refusal = key.server + " refuses a connection: " + answer.sentence();
      throw answer == Greeting.Answer.ENCRYPTED_ONLY || answer == Greeting.Answer.NOT_ENCRYPTED
          ? new ServerNotAcceptedException(refusal)
          : new IOException(refusal);
    }
  }
}
