package org.dfra.river.transport;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectableChannel;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import jdk.net.ExtendedSocketOptions;
import jdk.net.UnixDomainPrincipal;
import net.jini.io.context.ClientHost;
import org.dfra.river.identity.ChannelPeer;
import org.dfra.river.transport.local.LocalUser;
import org.jspecify.annotations.Nullable;

/** A link without encryption: a TCP connection, or one of a Unix-domain socket. */
final class SocketLink implements Link {

  private static final Path OWN_PROCESS = Path.of("/proc/self");

  private final SocketChannel channel;
  private final Peer peer;
  private final boolean leavesComputer;
  private long bytes;

  private SocketLink(SocketChannel channel, Peer peer, boolean leavesComputer) {
    this.channel = channel;
    this.peer = peer;
    this.leavesComputer = leavesComputer;
  }

  /** A TCP connection. */
  static SocketLink tcp(SocketChannel connected) throws IOException {
    connected.setOption(StandardSocketOptions.TCP_NODELAY, true);
    connected.setOption(StandardSocketOptions.SO_KEEPALIVE, true);
    InetSocketAddress from = (InetSocketAddress) connected.getRemoteAddress();
    if (from == null) {
      throw new IOException("the connection was closed again");
    }
    InetSocketAddress to = (InetSocketAddress) connected.getLocalAddress();
    boolean isSame = to != null && to.getAddress().equals(from.getAddress());
    return new SocketLink(connected, new Peer(from.getAddress(), null), !isSame);
  }

  /**
   * The server's side of a Unix-domain socket.
   *
   * @param host the address that stands for this computer
   * @throws IOException if the client's user cannot be determined
   */
  static Link unix(SocketChannel connected, InetAddress host) throws IOException {
    UnixDomainPrincipal runs = connected.getOption(ExtendedSocketOptions.SO_PEERCRED);
    return new PollingLink(new SocketLink(connected, new Peer(host, runs.user().getName()), false));
  }

  /**
   * The client's side of a Unix-domain socket.
   *
   * @param host the address that stands for this computer
   * @throws IOException if another user runs the server: the socket could be anybody's
   */
  static Link unixToOwnUser(SocketChannel connected, InetAddress host) throws IOException {
    Link link = unix(connected, host);
    String own = Files.getOwner(OWN_PROCESS).getName();
    if (!own.equals(link.peer().user())) {
      throw new IOException("its socket is of user " + link.peer().user() + ", not " + own);
    }
    return link;
  }

  @Override
  public int read(ByteBuffer into) throws IOException {
    int count = channel.read(into);
    if (count > 0) {
      bytes += count;
      TransportTraffic.countReceived(count, leavesComputer);
    }
    return count;
  }

  @Override
  public int write(ByteBuffer from) throws IOException {
    int count = channel.write(from);
    while (from.hasRemaining() && channel.isBlocking()) {
      count += channel.write(from);
    }
    bytes += count;
    TransportTraffic.countSent(count, leavesComputer);
    return count;
  }

  @Override
  public void setBlocking(boolean blocking) throws IOException {
    channel.configureBlocking(blocking);
  }

  @Override
  public void endOutput() throws IOException {
    channel.shutdownOutput();
  }

  @Override
  public void endInput() throws IOException {
    channel.shutdownInput();
  }

  @Override
  public boolean hasReceived() {
    return false;
  }

  @Override
  public int held() {
    return 0;
  }

  @Override
  public long bytes() {
    return bytes;
  }

  @Override
  public @Nullable ChannelPeer partner() {
    return null;
  }

  @Override
  public SelectableChannel channel() {
    return channel;
  }

  @Override
  public Peer peer() {
    return peer;
  }

  @Override
  public void addClientTo(Collection<Object> context) {
    context.add((ClientHost) peer::address);
    if (peer.user() != null) {
      context.add(new LocalUser(peer.user()));
    }
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }
}
