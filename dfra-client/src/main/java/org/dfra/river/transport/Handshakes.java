package org.dfra.river.transport;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.channels.SelectionKey;
import org.dfra.river.transport.ServerConnection.State;

/**
 * The handshakes of a selector's connections. The selector waits for their bytes, and the threads
 * of a {@link HandshakeQueue} compute.
 */
final class Handshakes {

  private static final System.Logger LOG = System.getLogger(Handshakes.class.getName());

  private final HandshakeQueue queue = new HandshakeQueue("dfra-handshake-", 2);
  private final HandshakeQueue stops = new HandshakeQueue("dfra-stop-handshake-", 1);
  private final ConnectionSelector selector;

  Handshakes(ConnectionSelector selector) {
    this.selector = selector;
  }

  /** Takes the next step, and does not read until that is done. On the selector's thread. */
  void proceed(SelectionKey key, ServerConnection connection) {
    key.interestOps(0);
    TlsLink link = (TlsLink) connection.link();
    HandshakeQueue its = connection.isPreferred(System.nanoTime()) ? stops : queue;
    its.add(link.peer().origin(), () -> advance(key, connection, link));
  }

  private void advance(SelectionKey key, ServerConnection connection, TlsLink link) {
    try {
      boolean isOver = link.advance();
      selector.submit(() -> resume(key, connection, isOver));
    } catch (IOException | RuntimeException e) { // also what a hostile peer makes JSSE throw
      LOG.log(Level.DEBUG, () -> "The handshake of " + link.peer() + " failed: " + e);
      if (link.isRefused()) {
        selector.submit(() -> refuse(key, connection));
      } else {
        connection.close();
      }
    }
  }

  /** TLS has no alert for this any more. The client learns that its request is not executed. */
  private void refuse(SelectionKey key, ServerConnection connection) {
    if (key.isValid() && connection.enter(State.HANDSHAKE, State.IDLE)) {
      key.interestOps(SelectionKey.OP_READ);
      selector.endGently(connection);
    }
  }

  private void resume(SelectionKey key, ServerConnection connection, boolean isEncrypted) {
    if (!key.isValid()) {
      return; // closed meanwhile
    }
    key.interestOps(SelectionKey.OP_READ);
    if (!isEncrypted || !connection.enter(State.HANDSHAKE, State.IDLE)) {
      return;
    }
    if (connection.port().isClosed()) {
      selector.endGently(connection);
    } else if (connection.link().held() > 0) { // what came with the end of the handshake
      selector.handle(key);
    }
  }
}
