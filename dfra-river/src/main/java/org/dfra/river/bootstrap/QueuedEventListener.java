package org.dfra.river.bootstrap;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import com.sun.jini.constants.ThrowableConstants;
import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.Serializable;
import java.rmi.RemoteException;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.Executor;
import net.jini.core.event.RemoteEvent;
import net.jini.core.event.RemoteEventListener;
import net.jini.core.event.UnknownEventException;
import org.dfra.river.registrar.EventFilter;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The lookup service's replacement for a client's event listener. It queues events and delivers
 * them in order, one call at a time, from the executor of the listener's process. Beyond {@value
 * #QUEUE_CAPACITY} waiting events the oldest is dropped: the client detects the gap in the sequence
 * numbers and reads everything again.
 *
 * <p>If the listener has answered that it no longer exists or wants no more events, the next event
 * throws that to the lookup service, which ends the registration. Otherwise the registration lasts
 * as long as its lease.
 *
 * <p>Reggie writes it to its log together with the client's original listener. An instance that is
 * read from the log delivers nothing until {@link EventListenerPreparer} has replaced it.
 * Thread-safe.
 */
final class QueuedEventListener implements RemoteEventListener, Serializable {

  private static final long serialVersionUID = 1L;

  private static final Logger LOG = LoggerFactory.getLogger(QueuedEventListener.class);

  /** Events that may wait; each costs about 100 bytes here. */
  private static final int QUEUE_CAPACITY = 128;

  private final RemoteEventListener listener;
  private final String client;
  private final boolean isFiltered; // false in logs of former versions
  private final transient @Nullable EventFilter filter;
  private final transient @Nullable Deliveries deliveries; // null if it was deserialized

  /**
   * @param listener the client's original
   * @param client the client's address
   * @param filter what the client sees of the events; null for all of them
   * @param bounded the same listener, called under a deadline
   * @param lane runs the calls; it drops none
   */
  QueuedEventListener(
      RemoteEventListener listener,
      String client,
      @Nullable EventFilter filter,
      RemoteEventListener bounded,
      Executor lane) {
    this.listener = listener;
    this.client = client;
    this.filter = filter;
    this.isFiltered = filter != null;
    this.deliveries = new Deliveries(bounded, lane);
  }

  /**
   * One that was read from a log.
   *
   * @throws InvalidObjectException if it is invalid
   */
  static QueuedEventListener recovered(
      @Nullable RemoteEventListener listener, @Nullable String client)
      throws InvalidObjectException {
    if (listener == null || client == null) {
      throw new InvalidObjectException("a lookup service's listener without proxy or address");
    }
    if (listener instanceof QueuedEventListener || listener instanceof RegistrarListener) {
      // possibly itself, which could not be unwrapped
      throw new InvalidObjectException("a lookup service's listener that holds another one");
    }
    return new QueuedEventListener(listener, client);
  }

  private QueuedEventListener(RemoteEventListener listener, String client) {
    this.listener = listener;
    this.client = client;
    this.filter = null;
    this.isFiltered = false;
    this.deliveries = null;
  }

  /** The client's original listener. */
  RemoteEventListener listener() {
    return listener;
  }

  /** The client's address. */
  String client() {
    return client;
  }

  /** Whether its client perhaps does not see everything. */
  boolean isFiltered() {
    return isFiltered;
  }

  /** Queues an event, unless the client does not see it; never waits for the listener. */
  @Override
  public void notify(RemoteEvent event) throws UnknownEventException, RemoteException {
    if (deliveries == null) {
      throw new IllegalStateException(
          "a listener that was read from a log is not prepared; name EventListenerPreparer as"
              + " recoveredListenerPreparer in the lookup service's configuration");
    }
    @Nullable RemoteEvent seen = filter == null ? event : filter.filtered(event);
    if (seen != null) {
      deliveries.offer(seen);
    }
  }

  /** Stops the delivery. */
  void close() {
    if (deliveries != null) {
      deliveries.close();
    }
  }

  /** Reggie uses this to keep the events to one listener in order. */
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof QueuedEventListener that && that.listener.equals(listener);
  }

  @Override
  public int hashCode() {
    return listener.hashCode();
  }

  @Override
  public String toString() {
    return "listener of " + client;
  }

  private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
    in.defaultReadObject();
    QueuedEventListener unused = recovered(listener, client);
  }

  /**
   * Events that wait for the listener; at most one is being delivered. It has no lambda, since an
   * archive of classes has neither the listener's class nor, therefore, its lambdas.
   */
  private static final class Deliveries implements Runnable {

    private final RemoteEventListener bounded;
    private final Executor lane;
    private final @Nullable ClassLoader loader = Thread.currentThread().getContextClassLoader();

    @GuardedBy("this")
    private final Queue<RemoteEvent> waiting = new ArrayDeque<>();

    @GuardedBy("this")
    private boolean isUnderWay;

    @GuardedBy("this")
    private boolean isClosed;

    // the listener's final exception
    @GuardedBy("this")
    private @Nullable Throwable end;

    Deliveries(RemoteEventListener bounded, Executor lane) {
      this.bounded = bounded;
      this.lane = lane;
    }

    synchronized void offer(RemoteEvent event) throws UnknownEventException, RemoteException {
      if (end instanceof UnknownEventException unknown) {
        throw unknown;
      }
      if (end instanceof RemoteException remote) {
        throw remote;
      }
      if (end != null) {
        throw new UnknownEventException("the listener failed: " + end);
      }
      if (isClosed) {
        return;
      }
      if (waiting.size() == QUEUE_CAPACITY) {
        RemoteEvent unused = waiting.remove();
      }
      waiting.add(event);
      if (!isUnderWay) {
        isUnderWay = true;
        lane.execute(this);
      }
    }

    synchronized void close() {
      isClosed = true;
      waiting.clear();
    }

    /** Delivers one event. */
    @Override
    public void run() {
      @Nullable RemoteEvent event;
      synchronized (this) {
        event = waiting.poll();
      }
      if (event != null) {
        call(event);
      }
      synchronized (this) {
        isUnderWay = !waiting.isEmpty();
        if (isUnderWay) {
          lane.execute(this);
        }
      }
    }

    private void call(RemoteEvent event) {
      Thread thread = Thread.currentThread();
      @Nullable ClassLoader before = thread.getContextClassLoader();
      thread.setContextClassLoader(loader);
      try {
        bounded.notify(event);
      } catch (UnknownEventException | RemoteException | RuntimeException | Error e) {
        failed(e);
      } finally {
        thread.setContextClassLoader(before);
      }
    }

    private void failed(Throwable e) {
      boolean isFinal = ThrowableConstants.retryable(e) != ThrowableConstants.INDEFINITE;
      LOG.debug("An event was not delivered{}.", isFinal ? ", and none will be" : "", e);
      if (isFinal) {
        synchronized (this) {
          end = e;
          waiting.clear();
        }
      }
    }
  }
}
