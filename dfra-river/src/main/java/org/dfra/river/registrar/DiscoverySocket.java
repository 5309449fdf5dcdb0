package org.dfra.river.registrar;

import java.io.IOException;
import java.net.Socket;
import java.net.SocketAddress;
import java.time.Duration;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A connection on which a lookup service answers discovery. It closes after a deadline. Without
 * one, reggie waits a minute for each byte that a client does not send, and waits for the system's
 * timeout when it connects to the address in a datagram.
 *
 * <p>Threads: one daemon for all, {@code dfra-discovery-ends}, while there are connections.
 */
final class DiscoverySocket extends Socket {

  /** The response has about 2 kB; a client times out after 2 s. */
  static final Duration MAX_LIFETIME = Duration.ofSeconds(5);

  /** The timeout of a connection to a client that sent a multicast request. */
  static final Duration CONNECT_TIMEOUT = Duration.ofSeconds(1);

  private static final Logger LOG = LoggerFactory.getLogger(DiscoverySocket.class);
  private static final long IDLE_SECONDS = 10;

  /** Not private, so that a test need not wait for the scheduled tasks. */
  static final ScheduledThreadPoolExecutor ENDS = ends();

  private final Consumer<DiscoverySocket> closed;
  private volatile @Nullable Future<?> end;

  /**
   * @param closed receives this socket when it is closed, possibly more than once
   */
  DiscoverySocket(Consumer<DiscoverySocket> closed) {
    this.closed = closed;
  }

  private static ScheduledThreadPoolExecutor ends() {
    ScheduledThreadPoolExecutor ends =
        new ScheduledThreadPoolExecutor(
            1,
            task -> {
              Thread thread = new Thread(task, "dfra-discovery-ends");
              thread.setDaemon(true);
              return thread;
            });
    ends.setRemoveOnCancelPolicy(true);
    ends.setKeepAliveTime(IDLE_SECONDS, TimeUnit.SECONDS);
    ends.allowCoreThreadTimeOut(true);
    return ends;
  }

  /** Starts the deadline. */
  void startDeadline() {
    end = ENDS.schedule(this::abort, MAX_LIFETIME.toMillis(), TimeUnit.MILLISECONDS);
  }

  /** Closes it immediately; blocked readers and writers get an exception. */
  void abort() {
    try {
      close();
    } catch (IOException e) {
      LOG.debug("A connection for discovery was not closed.", e);
    }
  }

  /** Connects within {@link #CONNECT_TIMEOUT}, whatever timeout is given. */
  @Override
  public void connect(SocketAddress endpoint, int timeout) throws IOException {
    int most = Math.toIntExact(CONNECT_TIMEOUT.toMillis());
    super.connect(endpoint, timeout == 0 ? most : Math.min(timeout, most));
    startDeadline();
  }

  @Override
  public void close() throws IOException {
    try {
      super.close();
    } finally {
      Future<?> ending = end;
      if (ending != null) {
        boolean unused = ending.cancel(false);
      }
      closed.accept(this);
    }
  }
}
