package org.dfra.river.call;

import java.io.Closeable;
import java.io.IOException;
import java.lang.System.Logger.Level;
import net.jini.jeri.OutboundRequest;
import org.jspecify.annotations.Nullable;

/**
 * One call on its way, shared between the caller that may give it up and the thread that waits for
 * its answer.
 */
final class CallInFlight {

  private static final System.Logger LOG = System.getLogger(CallInFlight.class.getName());
  private static final ThreadLocal<@Nullable CallInFlight> CURRENT = new ThreadLocal<>();

  private final boolean closesConnection;
  private @Nullable OutboundRequest request; // guarded by this
  private @Nullable Closeable connection; // guarded by this; until the request has left
  private boolean abandoned; // guarded by this
  private boolean ended; // guarded by this

  /** A call that leaves a connection alone which is still being made when the call is given up. */
  CallInFlight() {
    this(false);
  }

  /**
   * A call.
   *
   * @param closesConnection whether giving it up closes a connection that is still being made for
   *     it, so that its thread does not wait for a peer that takes connections and says nothing
   */
  CallInFlight(boolean closesConnection) {
    this.closesConnection = closesConnection;
  }

  /** Makes this the call of the current thread while {@code body} runs. */
  <T extends @Nullable Object> T runAsCurrent(Invocation<T> body) throws Throwable {
    CURRENT.set(this);
    try {
      return body.run();
    } finally {
      CURRENT.remove();
    }
  }

  /**
   * Notes by which request the current thread's call leaves, if it has one.
   *
   * @return the request
   */
  static OutboundRequest attachRequest(OutboundRequest request) {
    @Nullable CallInFlight call = CURRENT.get();
    if (call != null) {
      call.setRequest(request);
    }
    return request;
  }

  /**
   * Notes that the current thread's call, if it has one, makes this connection.
   *
   * @throws IOException if the call was given up before
   */
  static void attachConnection(Closeable connection) throws IOException {
    @Nullable CallInFlight call = CURRENT.get();
    if (call != null && call.closesConnection) {
      call.setConnection(connection);
    }
  }

  private synchronized void setConnection(Closeable made) throws IOException {
    if (abandoned) {
      throw new IOException("the call was given up before a connection was made for it");
    }
    connection = made;
  }

  private void setRequest(OutboundRequest leaving) {
    boolean tooLate;
    synchronized (this) {
      request = leaving;
      connection = null; // others may use it now
      tooLate = abandoned;
    }
    if (tooLate) {
      leaving.abort();
    }
  }

  /**
   * Gives the call up: the request is aborted, its thread comes free.
   *
   * @return false if the call had ended before
   */
  boolean abandon() {
    @Nullable OutboundRequest leaving;
    @Nullable Closeable unfinished;
    synchronized (this) {
      if (ended) {
        return false;
      }
      abandoned = true;
      leaving = request;
      unfinished = connection;
    }
    if (leaving != null) {
      leaving.abort();
    }
    if (unfinished != null) {
      close(unfinished);
    }
    return true;
  }

  private static void close(Closeable unfinished) {
    try {
      unfinished.close();
    } catch (IOException e) {
      LOG.log(Level.DEBUG, "A connection of a call that was given up was not closed in order.", e);
    }
  }

  /** Whether it was given up. */
  synchronized boolean isAbandoned() {
    return abandoned;
  }

  /**
   * Notes that the call's thread is free again.
   *
   * @return whether the call had been given up before
   */
  synchronized boolean finish() {
    ended = true;
    return abandoned;
  }

  /** Whether a connection was found for the call. */
  synchronized boolean hasRequest() {
    return request != null;
  }

  /**
   * Whether bytes of the call may have reached the server. Final once the call was abandoned or has
   * ended; before that, its first bytes may leave right after the answer.
   */
  synchronized boolean mayHaveRun() {
    return request != null && request.getDeliveryStatus();
  }

  /** What a call does. */
  interface Invocation<T extends @Nullable Object> {
    T run() throws Throwable;
  }
}
