package org.dfra.cli.stop;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Finds out which peers answer a connection attempt, thousands at once and without waiting for any.
 *
 * <p>Nothing is sent; a connection is closed as soon as it exists. A peer that refuses it has
 * answered too: a call of it fails at once. At most {@value #MAX_ATTEMPTS} attempts are open, each
 * for 1.5 s at most; further ones wait.
 *
 * <p>Thread: {@code dfra-stop-probe}, a daemon, until {@link #close}. If it cannot work, no peer
 * counts as answering.
 */
final class PeerProbe implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(PeerProbe.class);

  private static final int MAX_ATTEMPTS = 2048;
  private static final long TIMEOUT_NANOS =
      TimeUnit.MILLISECONDS.toNanos(1500); // TCP repeats after 1 s
  private static final long POLL_MILLIS = 50; // for attempts that have timed out

  @GuardedBy("this")
  private final Map<InetSocketAddress, CompletableFuture<Void>> answers = new HashMap<>();

  @GuardedBy("this")
  private final Queue<InetSocketAddress> waiting = new ArrayDeque<>();

  private final Set<Attempt> open = new LinkedHashSet<>(); // the oldest first; of the thread alone
  private volatile @Nullable Selector selector; // while the thread runs
  private volatile boolean closed;

  /** An open connection attempt. */
  private static final class Attempt {
    final SocketChannel channel;
    final InetSocketAddress peer;
    final long since = System.nanoTime();

    Attempt(SocketChannel channel, InetSocketAddress peer) {
      this.channel = channel;
      this.peer = peer;
    }
  }

  private PeerProbe() {}

  /** Starts the thread. */
  static PeerProbe start() {
    PeerProbe probe = new PeerProbe();
    Thread thread = new Thread(probe::run, "dfra-stop-probe");
    thread.setDaemon(true);
    thread.start();
    return probe;
  }

  /**
   * Attempts a connection, unless that was done before.
   *
   * @return complete when the peer has answered; never, if it does not answer
   */
  CompletableFuture<Void> answered(InetSocketAddress peer) {
    synchronized (this) {
      @Nullable CompletableFuture<Void> known = answers.get(peer);
      if (known != null) {
        return known;
      }
      CompletableFuture<Void> answer = new CompletableFuture<>();
      answers.put(peer, answer);
      waiting.add(peer);
      wakeUp();
      return answer;
    }
  }

  private void wakeUp() {
    @Nullable Selector current = selector;
    if (current != null) {
      var unused = current.wakeup();
    }
  }

  private void run() {
    try (Selector own = Selector.open()) {
      selector = own;
      while (!closed) {
        for (InetSocketAddress peer = next(); peer != null; peer = next()) {
          attempt(own, peer);
        }
        var unused = own.select(open.isEmpty() ? 0 : POLL_MILLIS);
        for (SelectionKey key : own.selectedKeys()) {
          finish((Attempt) key.attachment());
        }
        own.selectedKeys().clear();
        abandonOld();
      }
    } catch (IOException e) {
      LOG.debug("Peers are not probed.", e);
    } finally {
      open.forEach(each -> close(each.channel));
    }
  }

  private synchronized @Nullable InetSocketAddress next() {
    return closed || open.size() >= MAX_ATTEMPTS ? null : waiting.poll();
  }

  private void attempt(Selector own, InetSocketAddress peer) throws IOException {
    SocketChannel channel = SocketChannel.open();
    boolean isPending = false;
    try {
      var unused = channel.configureBlocking(false);
      isPending = !channel.connect(peer);
      if (isPending) {
        Attempt attempt = new Attempt(channel, peer);
        var key = channel.register(own, SelectionKey.OP_CONNECT, attempt);
        open.add(attempt);
      } else {
        answer(peer);
      }
    } catch (IOException | IllegalArgumentException e) { // a call of it would fail as fast
      isPending = false;
      answer(peer);
    } finally {
      if (!isPending) {
        close(channel);
      }
    }
  }

  private void finish(Attempt attempt) {
    try {
      boolean unused = attempt.channel.finishConnect();
    } catch (IOException e) {
      LOG.trace("{} refuses connections.", attempt.peer, e);
    }
    open.remove(attempt);
    close(attempt.channel);
    answer(attempt.peer);
  }

  private void abandonOld() {
    long now = System.nanoTime();
    while (!open.isEmpty()) {
      Attempt oldest = open.iterator().next();
      if (now - oldest.since < TIMEOUT_NANOS) {
        return;
      }
      open.remove(oldest);
      close(oldest.channel);
    }
  }

  /** Outside the lock: what follows an answer takes locks of its own. */
  private void answer(InetSocketAddress peer) {
    @Nullable CompletableFuture<Void> answer;
    synchronized (this) {
      answer = answers.get(peer);
    }
    if (answer != null) {
      answer.complete(null);
    }
  }

  private static void close(SocketChannel channel) {
    try {
      channel.close();
    } catch (IOException e) {
      LOG.trace("A connection attempt was not closed.", e);
    }
  }

  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      waiting.clear();
    }
    wakeUp();
  }
}
