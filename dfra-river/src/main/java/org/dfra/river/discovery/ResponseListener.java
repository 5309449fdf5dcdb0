package org.dfra.river.discovery;

import com.google.errorprone.annotations.concurrent.GuardedBy;
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
 * Accepts the connections of lookup services that answer a multicast request. At most {@value
 * #MAX_PENDING} connections wait to be read, at most {@value #PER_ADDRESS} of one address. A
 * further one is closed; its lookup service is found by its next announcement.
 *
 * <p>If its socket fails, it opens another, with the delays of {@link ReopenBackoff}: at the same
 * port, since requests contain it, or at another if that is taken. It ends only when it is closed.
 *
 * <p>Threads: one daemon, {@code dfra-discovery-responses}, from its start to {@link #close}.
 */
final class ResponseListener implements AutoCloseable {

  static final int MAX_PENDING = 16;
  static final int PER_ADDRESS = 2;

  private static final Logger LOG = LoggerFactory.getLogger(ResponseListener.class);

  /** Opens a server socket at a TCP port; for 0 the system chooses the port. */
  @FunctionalInterface
  interface ServerSocketOpener {
    ServerSocket open(int port) throws IOException;
  }

  private final ServerSocketOpener opening;
  private final Runnable responded;
  private final ReopenBackoff backoff = new ReopenBackoff();
  private final Deque<Socket> waiting = new ArrayDeque<>(); // guarded by itself

  @GuardedBy("this")
  private ServerSocket server;

  @GuardedBy("this")
  private int port;

  private ResponseListener(Runnable onResponse, ServerSocketOpener opening, ServerSocket first) {
    this.responded = onResponse;
    this.opening = opening;
    this.server = first;
    this.port = first.getLocalPort();
  }

  /**
   * Starts to listen.
   *
   * @param onResponse runs when a connection waits, on the listener's thread
   * @throws IOException if there is no port
   */
  static ResponseListener start(Runnable onResponse) throws IOException {
    return start(onResponse, ServerSocket::new);
  }

  /**
   * With sockets of another kind, for tests.
   *
   * @throws IOException if the first cannot be opened
   */
  static ResponseListener start(Runnable onResponse, ServerSocketOpener opening)
      throws IOException {
    ResponseListener listener = new ResponseListener(onResponse, opening, opening.open(0));
    Thread thread = new Thread(listener::accept, "dfra-discovery-responses");
    thread.setDaemon(true);
    thread.start();
    return listener;
  }

  /** The TCP port. */
  synchronized int port() {
    return port;
  }

  /** The connection that has waited longest; the caller closes it. */
  Optional<Socket> next() {
    synchronized (waiting) {
      return Optional.ofNullable(waiting.poll());
    }
  }

  private void accept() {
    while (!backoff.isClosed()) {
      try {
        take(server().accept());
      } catch (IOException e) {
        failed(e);
      }
    }
  }

  private synchronized ServerSocket server() {
    return server;
  }

  private void take(Socket socket) {
    if (backoff.succeeded()) {
      LOG.info("Answers to multicast requests are received again on port {}.", port());
    }
    try {
      if (add(socket)) {
        responded.run();
      } else {
        socket.close();
      }
    } catch (IOException | RuntimeException e) { // a fault of this connection, not of the port
      LOG.debug("An answer to a multicast request could not be handled.", e);
    }
  }

  /** Closes a connection without reading it. */
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
      if (backoff.isClosed() || same >= PER_ADDRESS || waiting.size() >= MAX_PENDING) {
        return false;
      }
      return waiting.add(socket);
    }
  }

  private void failed(IOException e) {
    if (backoff.failed() && !backoff.isClosed()) {
      LOG.warn(
          "Answers to multicast requests cannot be received now on port {}; it is opened again"
              + " until they can.",
          port(),
          e);
    }
    if (backoff.await()) {
      reopen();
    }
  }

  /** If that fails, the old socket stays closed, which causes the next attempt. */
  private synchronized void reopen() {
    try {
      server.close();
      server = open();
      port = server.getLocalPort();
      if (backoff.isClosed()) {
        server.close();
      }
    } catch (IOException e) {
      LOG.debug("Port {} cannot be opened yet.", port, e);
    }
  }

  private ServerSocket open() throws IOException {
    try {
      return opening.open(port());
    } catch (IOException e) {
      LOG.debug("Port {} is taken; another is opened.", port(), e);
      return opening.open(0);
    }
  }

  @Override
  public void close() {
    backoff.close();
    try {
      synchronized (this) {
        server.close();
      }
      for (Optional<Socket> each = next(); each.isPresent(); each = next()) {
        each.get().close();
      }
    } catch (IOException e) {
      LOG.debug("Port {} was not closed.", port(), e);
    }
  }
}
