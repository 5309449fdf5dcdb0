package org.dfra.river.transport;

import java.util.concurrent.TimeUnit;
import org.dfra.river.transport.ServerConnection.State;

/** How long a server's connection may be in each state. */
final class ConnectionTimeouts {

  /** The longest time between two parts of a request, until it was greeted, or for a handshake. */
  private static final long RECEIVE_NANOS = TimeUnit.SECONDS.toNanos(2);

  /** The longest time for a whole request to arrive: as long as the longest deadline of a call. */
  private static final long REQUEST_NANOS = TimeUnit.SECONDS.toNanos(30);

  /** The longest time between two blocks of a response. */
  private static final long ANSWER_NANOS = TimeUnit.SECONDS.toNanos(10);

  /** The longest time that a worker waits for a client that does not say whether it goes on. */
  private static final long WAITING_NANOS = TimeUnit.SECONDS.toNanos(2);

  /** Longer than clients keep idle connections. */
  static final long IDLE_NANOS = TimeUnit.SECONDS.toNanos(60);

  /** The time in which a client closes a connection after the server has announced the end. */
  private static final long CLOSING_NANOS = TimeUnit.SECONDS.toNanos(2);

  private ConnectionTimeouts() {}

  /** What becomes of a connection. */
  enum Decision {
    /** It is in time. */
    KEEP,
    /** The client is informed that it ends. */
    END,
    /** It is closed at once. */
    CLOSE
  }

  /**
   * Decides.
   *
   * @param now {@link System#nanoTime()}
   */
  static Decision check(ServerConnection connection, long now) {
    State state = connection.state();
    long waited = connection.nanosInState(state, now);
    return switch (state) {
      case GREETING, HANDSHAKE -> closeIf(waited >= RECEIVE_NANOS);
      case PARTIAL, RECEIVING ->
          closeIf(waited >= RECEIVE_NANOS || connection.nanosOfRequest(now) >= REQUEST_NANOS);
      case ANSWERING -> closeIf(waited >= ANSWER_NANOS);
      case CLOSING -> closeIf(waited >= CLOSING_NANOS);
      case EXECUTING -> Decision.KEEP;
      case IDLE -> waited >= IDLE_NANOS ? Decision.END : Decision.KEEP;
      case WAITING -> waited >= WAITING_NANOS ? Decision.END : Decision.KEEP;
    };
  }

  private static Decision closeIf(boolean isLate) {
    return isLate ? Decision.CLOSE : Decision.KEEP;
  }
}
