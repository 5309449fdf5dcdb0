package org.dfra.river.discovery;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Where lookup services connect to when they answer a multicast request. At most {@value #WAITING}
 * connections wait to be asked, at most {@value #PER_ADDRESS} of one address; a further one is
 * closed, and its lookup service is found by its next announcement.
 *
 * <p>Threads: one daemon, {@code dfra-discovery-responses}, from construction to {@link #close}.
 */
final class ResponseListener implements AutoCloseable {

  static final int WAITING = 16;
  static final int PER_ADDRESS = 2;

  private static final Logger LOG = LoggerFactory.getLogger(ResponseListener.class);

  private final ServerSocket server;
  private final Runnable responded;
  private final Deque<Socket> waiting = new ArrayDeque<>(); // guarded by itself

  /**
   * Listens from now on.
   *
   * @param responded is run when a connection waits, on the listener's thread
   * @throws IOException if there is no port
   */
  ResponseListener(Runnable responded) throws IOException {
    this.responded = responded;
    this.server = new ServerSocket(0);
    Thread thread = new Thread(this::accept, "dfra-discovery-responses");
    thread.setDaemon(true);
    thread.start();
  }

  /** The TCP port. */
  int port() {
    return server.getLocalPort();
  }

  /** The connection that has waited longest; the caller closes it. */
  Optional<Socket> next() {
    synchronized (waiting) {
      return Optional.ofNullable(waiting.poll());
    }
  }

  private void accept() {
    while (!server.isClosed()) {
      try {
        Socket socket = server.accept();
        if (add(socket)) {
          responded.run();
        } else {
          socket.close();
        }
      } catch (IOException e) {
        if (!server.isClosed()) {
          LOG.warn("Answers to multicast requests are received no more on port {}.", port(), e);
          close();
        }
      }
    }
  }

  /** Closes a connection that is not asked. */
  static void drop(Socket socket) {
    try {
      socket.close();
    } catch (IOException e) {
      LOG.debug("The connection of a lookup service was not closed.", e);
    }
  }

  private boolean add(Socket socket) {
    InetAddress from = socket.getInetAddress();
    synchronized (waiting) {
      long same = waiting.stream().filter(each -> from.equals(each.getInetAddress())).count();
      if (server.isClosed() || same >= PER_ADDRESS || waiting.size() >= WAITING) {
        return false;
      }
      return waiting.add(socket);
    }
  }

  @Override
  public void close() {
    try {
      server.close();
      for (Optional<Socket> each = next(); each.isPresent(); each = next()) {
        each.get().close();
      }
    } catch (IOException e) {
      LOG.debug("Port {} was not closed.", port(), e);
    }
  }
}
