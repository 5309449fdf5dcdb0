package org.dfra.river.loading;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Accepts the connections of a {@link ClassServer} and answers one HTTP request on each.
 *
 * <p>No client can block others. An address has at most {@value #PER_ADDRESS} connections at a time
 * and all addresses together at most {@value #CONNECTIONS}, each with one thread. A request must
 * arrive completely within 2 s of its connection, and the client must read the response within 60
 * s. If all slots are in use, a new client replaces the oldest request that is still incomplete. If
 * there is none, the slots are held by clients that read their responses slowly: then the new
 * client replaces a connection of the address that holds most slots, if it holds fewer itself. The
 * JDK's own server has no limits per address.
 */
final class HttpListener implements AutoCloseable {

  static final int PER_ADDRESS = 8;
  static final int CONNECTIONS = 64;

  /** One thread accepts; the thread of a replaced connection may take a moment to end. */
  private static final int THREADS = CONNECTIONS + 16;

  private static final Duration STOP_TIMEOUT = Duration.ofSeconds(5);
  private static final Duration REQUEST_TIMEOUT = Duration.ofSeconds(2);
  private static final Duration RESPONSE_TIMEOUT = Duration.ofSeconds(60);

  private static final Logger LOG = LoggerFactory.getLogger(HttpListener.class);

  private final ServerSocket listening;
  private final HttpResponder answers;
  private final CountDownLatch accepting = new CountDownLatch(1);
  private final ThreadPoolExecutor threads;
  final ScheduledThreadPoolExecutor deadlines; // not private, so that a test need not wait
  private final Set<HttpConnection> open = new LinkedHashSet<>(); // guarded by itself, oldest first

  @GuardedBy("open")
  private final Map<InetAddress, Integer> byAddress = new HashMap<>();

  private HttpListener(ServerSocket listening, HttpResponder answers) {
    this.listening = listening;
    this.answers = answers;
    ThreadFactory named = named();
    deadlines = new ScheduledThreadPoolExecutor(1, named);
    deadlines.setRemoveOnCancelPolicy(true);
    threads =
        new ThreadPoolExecutor(0, THREADS, 10, TimeUnit.SECONDS, new SynchronousQueue<>(), named);
  }

  /**
   * Starts to listen.
   *
   * @throws IOException if the address cannot be listened on
   */
  static HttpListener start(InetSocketAddress address, HttpResponder answers) throws IOException {
    ServerSocket listening = new ServerSocket();
    try {
      listening.setReuseAddress(true);
      listening.bind(address, CONNECTIONS);
    } catch (IOException | RuntimeException e) {
      listening.close();
      throw e;
    }
    HttpListener listener = new HttpListener(listening, answers);
    listener.threads.execute(listener::accept);
    return listener;
  }

  private static ThreadFactory named() {
    AtomicInteger number = new AtomicInteger();
    return task -> {
      Thread thread = Executors.defaultThreadFactory().newThread(task);
      thread.setName("class server " + number.incrementAndGet());
      thread.setDaemon(true);
      return thread;
    };
  }

  /** The TCP port it listens on. */
  int port() {
    return listening.getLocalPort();
  }

  /** Stops listening and closes the open connections. Does nothing if it was closed. */
  @Override
  public void close() {
    try {
      listening.close();
    } catch (IOException e) {
      LOG.warn("The class server's port {} could not be closed.", port(), e);
    }
    List<HttpConnection> ending;
    synchronized (open) {
      ending = new ArrayList<>(open);
    }
    ending.forEach(HttpConnection::abort);
    threads.shutdownNow();
    deadlines.shutdownNow();
    awaitEnd();
  }

  /** The port is not free until the accepting thread has ended. */
  private void awaitEnd() {
    try {
      if (!accepting.await(STOP_TIMEOUT.toMillis(), TimeUnit.MILLISECONDS)) {
        LOG.warn("The class server's port {} is not free yet after {}.", port(), STOP_TIMEOUT);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void accept() {
    try {
      acceptAll();
    } finally {
      accepting.countDown();
    }
  }

  private void acceptAll() {
    while (!listening.isClosed()) {
      try {
        serve(listening.accept());
      } catch (SocketException e) {
        if (listening.isClosed()) {
          return;
        }
        LOG.warn("The class server could not accept a connection; it continues.", e);
        pause();
      } catch (IOException | RejectedExecutionException e) {
        if (!listening.isClosed()) {
          LOG.warn("The class server could not serve a connection; it continues.", e);
          pause();
        }
      }
    }
  }

  /** So that a lack of descriptors does not cause a busy loop. */
  private void pause() {
    try {
      if (deadlines.awaitTermination(50, TimeUnit.MILLISECONDS)) {
        LOG.debug("The class server ended while it could not accept.");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void serve(Socket socket) throws IOException {
    HttpConnection connection = new HttpConnection(socket, answers, this::left);
    if (!admit(connection)) {
      connection.abort();
      return;
    }
    try {
      connection.setDeadlines(
          deadlines.schedule(
              connection::abortIfIncomplete, REQUEST_TIMEOUT.toMillis(), TimeUnit.MILLISECONDS),
          deadlines.schedule(
              connection::abort, RESPONSE_TIMEOUT.toMillis(), TimeUnit.MILLISECONDS));
      threads.execute(connection);
    } catch (RejectedExecutionException e) { // the listener is closing
      connection.abort();
      left(connection);
      throw e;
    } catch (OutOfMemoryError e) { // no thread is available
      connection.abort();
      left(connection);
      throw new IOException("no thread can be started for " + connection.address(), e);
    }
  }

  /** Whether a connection may stay; the oldest incomplete request may be closed for it. */
  private boolean admit(HttpConnection connection) {
    @Nullable HttpConnection replaced = null;
    synchronized (open) {
      int same = byAddress.getOrDefault(connection.address(), 0);
      if (same >= PER_ADDRESS) {
        return false;
      }
      if (open.size() >= CONNECTIONS) {
        replaced = oldestIncomplete(open);
        if (replaced == null) {
          replaced = oldestOfBusiest(same + 1);
        }
        if (replaced == null) {
          return false;
        }
        remove(replaced);
      }
      open.add(connection);
      byAddress.put(connection.address(), same + 1);
    }
    if (replaced != null) {
      replaced.abort();
    }
    return true;
  }

  private static @Nullable HttpConnection oldestIncomplete(Collection<HttpConnection> connections) {
    for (HttpConnection each : connections) {
      if (!each.isComplete()) {
        return each;
      }
    }
    return null;
  }

  /**
   * The oldest connection of the address with most connections, if these are more than {@code few}.
   */
  @GuardedBy("open")
  private @Nullable HttpConnection oldestOfBusiest(int few) {
    @Nullable HttpConnection oldest = null;
    int most = few;
    for (HttpConnection each : open) {
      int count = byAddress.getOrDefault(each.address(), 0);
      if (count > most) {
        most = count;
        oldest = each;
      }
    }
    return oldest;
  }

  private void left(HttpConnection connection) {
    synchronized (open) {
      remove(connection);
    }
  }

  @GuardedBy("open")
  private void remove(HttpConnection connection) {
    if (open.remove(connection)) {
      byAddress.merge(connection.address(), -1, Integer::sum);
      byAddress.remove(connection.address(), 0);
    }
  }

  /** Computes the response of an HTTP server to {@code GET} and {@code HEAD}. */
  @FunctionalInterface
  interface HttpResponder {

    /**
     * @param path of the request, as it was written, without a query
     * @throws IOException if it cannot be answered; the connection is then closed
     */
    HttpReply answer(String path) throws IOException;

    /**
     * @param status such as 200
     * @param headers besides {@code Content-Length}
     * @param body sent after the headers, except for {@code HEAD}
     */
    record HttpReply(int status, Map<String, String> headers, byte[] body) {

      static final HttpReply NOT_FOUND = new HttpReply(404, Map.of(), new byte[0]);
    }
  }
}
