package org.dfra.river.transport;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.Closeable;
import java.io.IOException;
import java.lang.System.Logger.Level;
import net.jini.jeri.OutboundRequest;
import org.jspecify.annotations.Nullable;

/**
 * One running call, shared between the thread that waits for its response and the one that may
 * abandon it: {@link CallWatchdog}, or a caller that waits on another thread.
 */
public final class CallInFlight {

  private static final System.Logger LOG = System.getLogger(CallInFlight.class.getName());
  private static final ThreadLocal<@Nullable CallInFlight> CURRENT = new ThreadLocal<>();

  private final boolean closesConnection;
  private final boolean isStop;

  @GuardedBy("this")
  private @Nullable OutboundRequest request;

  // until the request is sent
  @GuardedBy("this")
  private @Nullable Closeable connection;

  @GuardedBy("this")
  private boolean abandoned;

  @GuardedBy("this")
  private boolean ended;

  /** A call that, when abandoned, does not close a connection that is still being established. */
  public CallInFlight() {
    this(false);
  }

  /**
   * A call.
   *
   * @param closesConnection whether abandoning it closes a connection that is still being
   *     established for it, so that its thread does not wait for a peer that accepts connections
   *     and sends nothing
   */
  public CallInFlight(boolean closesConnection) {
    this(closesConnection, false);
  }

  private CallInFlight(boolean closesConnection, boolean isStop) {
    this.closesConnection = closesConnection;
    this.isStop = isStop;
  }

  /**
   * A call that, when abandoned, closes a connection that is still being established.
   *
   * @param isStop whether it makes an emergency stop; its server keeps capacity for it
   */
  public static CallInFlight closing(boolean isStop) {
    return new CallInFlight(true, isStop);
  }

  /** Whether the current thread's call makes an emergency stop. */
  static boolean isCurrentStop() {
    @Nullable CallInFlight call = CURRENT.get();
    return call != null && call.isStop;
  }

  /** Makes this the call of the current thread while {@code body} runs. */
  public <T extends @Nullable Object> T runAsCurrent(Invocation<T> body) throws Throwable {
    @Nullable CallInFlight outer = CURRENT.get(); // whose arguments or result make this call
    CURRENT.set(this);
    try {
      return body.run();
    } finally {
      if (outer == null) {
        CURRENT.remove();
      } else {
        CURRENT.set(outer);
      }
    }
  }

  /**
   * Records the request that sends the current thread's call, if there is one.
   *
   * @return the request
   */
  public static OutboundRequest attachRequest(OutboundRequest request) {
    @Nullable CallInFlight call = CURRENT.get();
    if (call != null) {
      call.setRequest(request);
    }
    return request;
  }

  /**
   * Records the connection that the current thread's call, if there is one, establishes.
   *
   * @throws IOException if the call was already abandoned
   */
  public static void attachConnection(Closeable connection) throws IOException {
    @Nullable CallInFlight call = CURRENT.get();
    if (call != null && call.closesConnection) {
      call.setConnection(connection);
    }
  }

  /**
   * Ends an attempt of the current thread's call if it must not be followed by another one.
   *
   * @param failure of the attempt
   * @throws IOException the failure, if the call was abandoned or its thread interrupted
   */
  static void checkNotAbandoned(IOException failure) throws IOException {
    @Nullable CallInFlight call = CURRENT.get();
    if (Thread.currentThread().isInterrupted() || (call != null && call.isAbandoned())) {
      throw failure;
    }
  }

  /**
   * As {@link #attachConnection}, for an attempt that is made because no former one was delivered.
   *
   * @throws IOException if the call was already abandoned
   */
  static void attachAttempt(Closeable connection) throws IOException {
    @Nullable CallInFlight call = CURRENT.get();
    if (call != null) {
      call.forgetRequest();
      attachConnection(connection);
    }
  }

  private synchronized void forgetRequest() {
    request = null;
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
   * Abandons the call: its request is aborted and its thread is released.
   *
   * @return false if the call had already ended
   */
  public boolean abandon() {
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

  /** Whether it was abandoned. */
  public synchronized boolean isAbandoned() {
    return abandoned;
  }

  /**
   * Records that the call's thread is free again.
   *
   * @return whether the call had already been abandoned
   */
  public synchronized boolean finish() {
    ended = true;
    return abandoned;
  }

  /** Whether a connection was found for the call. */
  public synchronized boolean hasRequest() {
    return request != null;
  }

  /**
   * Whether bytes of the call may have reached the server. The answer is final once the call was
   * abandoned or has ended; before that, its first bytes may be sent right after the answer.
   */
  public synchronized boolean mayHaveRun() {
    return request != null && request.getDeliveryStatus();
  }

  /**
   * The work of a call.
   *
   * @param <T> its result
   */
  public interface Invocation<T extends @Nullable Object> {

    /** Makes the call. */
    T run() throws Throwable;
  }
}
