package org.dfra.cli.stop;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.ArrayList;
import java.util.List;
import org.dfra.river.call.PeerAddress;

/**
 * An address of this computer that does not answer connection attempts, as one that nobody has: a
 * listening socket whose queue is full. Linux drops further attempts.
 */
record UnreachablePeer(ServerSocket server, List<Socket> queue) implements AutoCloseable {

  private static final int ATTEMPTS = 10;

  /**
   * Opens it, and fills the queue.
   *
   * @param host an address of the loopback interface
   */
  static UnreachablePeer open(String host) throws IOException {
    ServerSocket server = new ServerSocket(0, 1, InetAddress.getByName(host));
    List<Socket> queue = new ArrayList<>();
    for (int i = 0; i < ATTEMPTS; i++) {
      Socket socket = new Socket();
      queue.add(socket);
      try {
        socket.connect(new InetSocketAddress(server.getInetAddress(), server.getLocalPort()), 20);
      } catch (SocketTimeoutException e) {
        return new UnreachablePeer(server, queue);
      }
    }
    throw new IOException("the queue of " + server + " is never full");
  }

  PeerAddress address() {
    return new PeerAddress(server.getInetAddress().getHostAddress(), server.getLocalPort());
  }

  @Override
  public void close() throws IOException {
    for (Socket each : queue) {
      each.close();
    }
    server.close();
  }
}
