package org.dfra.river.registrar;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * The server socket for unicast discovery of a lookup service. Reggie reads each connection on one
 * of its 50 threads, which also deliver its events. So at most {@value #CONNECTIONS} connections
 * are open at a time, and {@value #PER_ADDRESS} from one address. Beyond that a new connection
 * replaces the oldest, since a legitimate request completes within milliseconds. Each {@link
 * DiscoverySocket} closes after a deadline.
 */
final class DiscoveryServerSocket extends ServerSocket {

  static final int CONNECTIONS = 32;
  static final int PER_ADDRESS = 16;

  /** Guarded by itself; the oldest comes first. */
  private final Set<DiscoverySocket> open = new LinkedHashSet<>();

  /** Starts to listen, as {@link ServerSocket} does. */
  DiscoveryServerSocket(int port, int backlog, @Nullable InetAddress address) throws IOException {
    super(port, backlog, address);
  }

  @Override
  public Socket accept() throws IOException {
    if (isClosed()) {
      throw new SocketException("this socket for discovery is closed");
    }
    DiscoverySocket socket = new DiscoverySocket(this::left);
    implAccept(socket);
    socket.startDeadline();
    add(socket).ifPresent(DiscoverySocket::abort);
    return socket;
  }

  /** Adds a connection; returns the one to close for it. */
  private Optional<DiscoverySocket> add(DiscoverySocket socket) {
    synchronized (open) {
      Optional<DiscoverySocket> replaced = Optional.empty();
      if (open.stream().filter(each -> isSame(each, socket)).count() >= PER_ADDRESS) {
        replaced = open.stream().filter(each -> isSame(each, socket)).findFirst();
      } else if (open.size() >= CONNECTIONS) {
        replaced = open.stream().findFirst();
      }
      replaced.ifPresent(open::remove);
      open.add(socket);
      return replaced;
    }
  }

  private static boolean isSame(Socket one, Socket other) {
    @Nullable InetAddress address = one.getInetAddress();
    return address != null && address.equals(other.getInetAddress());
  }

  private void left(DiscoverySocket socket) {
    synchronized (open) {
      boolean unused = open.remove(socket);
    }
  }
}
