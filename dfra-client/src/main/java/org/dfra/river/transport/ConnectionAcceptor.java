package org.dfra.river.transport;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.channels.CancelledKeyException;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.SelectionKey;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.dfra.river.transport.ConnectionLimits.Resource;
import org.dfra.river.transport.ServerConnection.State;
import org.jspecify.annotations.Nullable;

/**
 * Accepts connections. Where there are too many, the one that was idle longest is closed: of the
 * same address if that has too many, otherwise of the address that has most. So a peer that opens
 * many loses only its own. Confined to the selector's thread.
 */
final class ConnectionAcceptor {

  private static final System.Logger LOG = System.getLogger(ConnectionAcceptor.class.getName());

  private static final Set<State> IDLE_STATES =
      EnumSet.of(State.IDLE, State.GREETING, State.HANDSHAKE);

  /** Beyond, those that wait are accepted when other connections had their turn. */
  private static final int ACCEPTED_IN_TURN = 32;

  private static final long LOG_AGAIN_NANOS = TimeUnit.SECONDS.toNanos(10);

  private final ConnectionSelector selector;
  private final ConnectionLimits limits;
  private final Set<ServerConnection> connections;
  private boolean isPaused; // too many files were open
  private long logged = System.nanoTime() - LOG_AGAIN_NANOS;

  ConnectionAcceptor(
      ConnectionSelector selector, ConnectionLimits limits, Set<ServerConnection> connections) {
    this.selector = selector;
    this.limits = limits;
    this.connections = connections;
  }

  /** Whether a port waits for {@link #resume}. */
  boolean isPaused() {
    return isPaused;
  }

  /** Accepts what waits at a port. */
  void accept(SelectionKey key, ServerPort port) {
    try {
      ServerSocketChannel from = (ServerSocketChannel) key.channel();
      for (int i = 0; i < ACCEPTED_IN_TURN; i++) {
        @Nullable SocketChannel accepted = from.accept();
        if (accepted == null) {
          return;
        }
        adopt(port, from, accepted);
      }
    } catch (ClosedChannelException | CancelledKeyException e) {
      LOG.log(Level.DEBUG, "A port was closed.", e);
    } catch (IOException e) { // for example too many open files
      logFull("A connection was not accepted: " + e.getMessage());
      closeLongestIdle(List.copyOf(connections));
      isPaused = true;
      key.interestOps(0); // or this would happen over and over
    }
  }

  /** Accepts again after too many files were open. */
  void resume(Set<SelectionKey> keys) {
    isPaused = false;
    for (SelectionKey key : keys) {
      if (key.isValid() && key.attachment() instanceof ServerPort && key.interestOps() == 0) {
        key.interestOps(SelectionKey.OP_ACCEPT);
      }
    }
  }

  private void adopt(ServerPort port, ServerSocketChannel from, SocketChannel accepted)
      throws IOException {
    try {
      Link link = port.link(from, accepted);
      link.setBlocking(false);
      if (!takePlace(link.peer())) {
        logFull(link.peer() + " has too many connections; a further one is refused");
        int unused = link.write(Greeting.server(Greeting.Answer.BUSY));
        link.close();
        return;
      }
      selector.adopt(new ServerConnection(port, link, selector));
    } catch (IOException e) { // it was closed at once
      LOG.log(Level.DEBUG, "A connection ended before it began.", e);
      accepted.close();
    }
  }

  private boolean takePlace(Peer peer) {
    if (limits.take(Resource.CONNECTIONS, peer, 1)) {
      return true;
    }
    Object origin = limits.isExhausted(Resource.CONNECTIONS, peer) ? peer.origin() : largest();
    closeLongestIdle(
        connections.stream().filter(each -> each.link().peer().origin().equals(origin)).toList());
    return limits.take(Resource.CONNECTIONS, peer, 1);
  }

  /** The address with most connections. */
  private Object largest() {
    return connections.stream()
        .map(each -> each.link().peer())
        .filter(each -> !each.isLocalUser())
        .collect(Collectors.groupingBy(Peer::origin, Collectors.counting()))
        .entrySet()
        .stream()
        .max(Map.Entry.comparingByValue())
        .<Object>map(Map.Entry::getKey)
        .orElse("");
  }

  private void closeLongestIdle(List<ServerConnection> among) {
    long now = System.nanoTime();
    among.stream()
        .filter(each -> IDLE_STATES.contains(each.state()) && !each.isPreferred(now))
        .max(Comparator.comparingLong(each -> each.nanosInState(now)))
        .ifPresent(
            each -> {
              selector.endGently(each);
              each.close();
            });
  }

  /** Logs that a limit was reached, at most once in ten seconds. */
  void logFull(String message) {
    long now = System.nanoTime();
    if (now - logged >= LOG_AGAIN_NANOS) {
      logged = now;
      LOG.log(Level.WARNING, message);
    }
  }
}
