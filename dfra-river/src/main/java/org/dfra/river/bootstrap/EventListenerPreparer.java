package org.dfra.river.bootstrap;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.rmi.RemoteException;
import java.util.IdentityHashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.Set;
import net.jini.core.event.RemoteEventListener;
import net.jini.security.ProxyPreparer;
import org.dfra.river.call.CallbackProxies;
import org.dfra.river.callback.CallbackLimiter;
import org.dfra.river.callback.CallbackLimiter.CallbackSlot;
import org.dfra.river.callback.CallbackRefusedException;
import org.dfra.river.callback.ClientAddress;
import org.dfra.river.registrar.EventFilter;

/**
 * Prepares the event listeners of one lookup service, for the entries {@code listenerPreparer} and
 * {@code recoveredListenerPreparer} of {@code com.sun.jini.reggie}; both use one object.
 *
 * <p>Reggie calls each listener through its proxy, from at most 50 threads that also answer
 * discovery. So a few listeners that never answer would block both. Here each listener is replaced
 * by a {@link QueuedEventListener}, which only queues the events and calls the listener from the
 * executor of its process, under a deadline of this computer.
 *
 * <p>The number of listeners of a client is checked before reggie sees one, by {@link
 * org.dfra.river.registrar.RegistrarILFactory}. This class counts the client's processes, see
 * {@link CallbackLimiter}. Reggie does not report the end of a registration, so {@link
 * RegistrarExporter} reports the current registrations every second. A lookup service with another
 * exporter keeps no slots. Thread-safe.
 */
public final class EventListenerPreparer implements ProxyPreparer {

  private final String host;
  private final CallbackLimiter peers;

  @GuardedBy("this")
  private final Map<QueuedEventListener, TrackedListener> registered = new IdentityHashMap<>();

  @GuardedBy("this")
  private boolean isWatched;

  /** The slot that a listener holds. */
  private static final class TrackedListener {
    final CallbackSlot place;
    boolean isMissed; // guarded by the listeners: absent from reggie at the last check

    TrackedListener(CallbackSlot place) {
      this.place = place;
    }
  }

  /**
   * @param host address or name that the lookup service's proxy carries: clients at that address
   *     are on this computer
   */
  public EventListenerPreparer(String host) {
    this(host, CallbackLimiter.shared());
  }

  /**
   * For tests.
   *
   * @param peers counts the listeners' processes
   */
  EventListenerPreparer(String host, CallbackLimiter peers) {
    this.host = host;
    this.peers = peers;
  }

  /**
   * Replaces a listener that a client has sent, or that reggie has read from its log.
   *
   * @throws SecurityException if it is no listener, if reggie has read it from its log and its
   *     owner perhaps does not see everything, or if it is in a further process of its client and
   *     that client's processes have reached their limit
   */
  @Override
  public Object prepareProxy(Object proxy) throws RemoteException {
    if (!(proxy instanceof RemoteEventListener)) {
      throw new SecurityException(
          "the lookup service got a "
              + proxy.getClass().getName()
              + " as listener; export a RemoteEventListener and send its proxy");
    }
    if (proxy instanceof QueuedEventListener recovered
        && isRecovering()
        && recovered.isFiltered()) {
      throw new SecurityException(
          "who owns "
              + recovered
              + " is not known after a restart of the lookup service, nor what is hidden from it;"
              + " it has to register again");
    }
    ClientAddress client = client(proxy);
    RemoteEventListener listener = unwrapped((RemoteEventListener) proxy);
    return register(listener, client);
  }

  private synchronized boolean isRecovering() {
    return !isWatched;
  }

  /** Reggie reads its log before it is exported. A client's own claims are not trusted. */
  private synchronized ClientAddress client(Object proxy) {
    if (!isWatched && proxy instanceof QueuedEventListener recovered) {
      return ClientAddress.of(recovered.client(), host);
    }
    return ClientAddress.ofCurrentCall(host);
  }

  private static RemoteEventListener unwrapped(RemoteEventListener listener) {
    return listener instanceof QueuedEventListener wrapper ? wrapper.listener() : listener;
  }

  private synchronized QueuedEventListener register(
      RemoteEventListener listener, ClientAddress client) {
    try {
      CallbackSlot place = peers.admit(client, listener);
      QueuedEventListener made =
          new QueuedEventListener(
              listener,
              client.host(),
              EventFilter.CURRENT.get(),
              CallbackProxies.withDeadline(
                  listener, RemoteEventListener.class, CallbackProxies.DEADLINE),
              place.lane());
      if (isWatched) {
        registered.put(made, new TrackedListener(place));
      } else {
        place.close();
      }
      return made;
    } catch (CallbackRefusedException e) {
      throw new SecurityException(String.valueOf(e.getMessage()), e);
    }
  }

  /** Slots are held from now on, since {@link #retain} will be called every second. */
  synchronized void startTracking() {
    isWatched = true;
  }

  /**
   * Releases the slots of listeners that are no longer registered. A listener must be missing
   * twice, because one that is being registered is not there yet.
   *
   * @param live all registered listeners, compared by identity
   */
  synchronized void retain(Set<Object> live) {
    for (Iterator<Map.Entry<QueuedEventListener, TrackedListener>> all =
            registered.entrySet().iterator();
        all.hasNext(); ) {
      Map.Entry<QueuedEventListener, TrackedListener> each = all.next();
      QueuedEventListener listener = each.getKey(); // the entry disappears with its removal
      TrackedListener its = each.getValue();
      if (live.contains(listener)) {
        its.isMissed = false;
      } else if (!its.isMissed) {
        its.isMissed = true;
      } else {
        all.remove();
        listener.close();
        its.place.close();
      }
    }
  }
}
