package org.dfra.river.bootstrap;

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
 * A connection on which a lookup service answers discovery. It ends by itself: reggie waits a
 * minute for each byte that a client does not send, and as long as the system does for a connection
 * to the address that a datagram names.
 *
 * <p>Threads: one daemon for all, {@code dfra-discovery-ends}, while there are connections.
 */
final class DiscoverySocket extends Socket {

  /** The answer has about 2 kB; a client gives up after 2 s. */
  static final Duration MAX_LIFETIME = Duration.ofSeconds(5);

  /** For a connection to a client that has asked by multicast. */
  static final Duration CONNECT_TIMEOUT = Duration.ofSeconds(1);

  private static final Logger LOG = LoggerFactory.getLogger(DiscoverySocket.class);
  private static final long IDLE_SECONDS = 10;

  /** Not private, so that a test need not wait for what is scheduled here. */
  static final ScheduledThreadPoolExecutor ENDS = ends();

  private final Consumer<DiscoverySocket> closed;
  private volatile @Nullable Future<?> end;

  /**
   * @param closed is given this when it is closed, possibly more than once
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

  /** Its time begins. */
  void startDeadline() {
    end = ENDS.schedule(this::abort, MAX_LIFETIME.toMillis(), TimeUnit.MILLISECONDS);
  }

  /** Ends it at once; whoever reads or writes it gets an exception. */
  void abort() {
    try {
      close();
    } catch (IOException e) {
      LOG.debug("A connection for discovery was not closed.", e);
    }
  }

  /** Connects within {@link #CONNECT_TIMEOUT}, whatever is asked for. */
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
