package org.dfra.river.bootstrap;

import java.rmi.RemoteException;
import java.util.IdentityHashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.Set;
import net.jini.core.event.RemoteEventListener;
import net.jini.security.ProxyPreparer;
import org.dfra.river.call.CallbackProxies;
import org.dfra.river.callback.CallbackLimiter;
import org.dfra.river.callback.CallbackRefusedException;
import org.dfra.river.callback.CallbackSlot;
import org.dfra.river.callback.ClientAddress;

/**
 * The event listeners of one lookup service: for the entries {@code listenerPreparer} and {@code
 * recoveredListenerPreparer} of {@code com.sun.jini.reggie}, one object for both.
 *
 * <p>Reggie calls each listener as its proxy wants, from 50 threads or fewer that also answer
 * discovery; so a few listeners that never answer would end both. Here each listener is replaced by
 * a {@link RegistrarListener}, which only queues the events and calls the listener in the lane of
 * its process, under a deadline of this computer's.
 *
 * <p>How many listeners a client may have is checked before reggie sees one, by {@link
 * org.dfra.river.registrar.RegistrarILFactory}. Here its processes are counted, see {@link
 * CallbackLimiter}. Reggie does not report when a registration ends, so {@link RegistrarExporter}
 * says each second which ones there are. A lookup service that is exported otherwise keeps no
 * places. Thread-safe.
 */
public final class EventListenerPreparer implements ProxyPreparer {

  private final String host;
  private final CallbackLimiter peers;
  private final Map<RegistrarListener, TrackedListener> registered =
      new IdentityHashMap<>(); // guarded by this
  private boolean isWatched; // guarded by this

  /** What a listener holds here. */
  private static final class TrackedListener {
    final CallbackSlot place;
    boolean isMissed; // guarded by the listeners: reggie did not have it when it was looked for

    TrackedListener(CallbackSlot place) {
      this.place = place;
    }
  }

  /**
   * @param host address or name that the lookup service's proxy carries: clients there are on this
   *     computer
   */
  public EventListenerPreparer(String host) {
    this(host, CallbackLimiter.shared());
  }

  /**
   * The same, for tests.
   *
   * @param peers count the listeners' processes
   */
  EventListenerPreparer(String host, CallbackLimiter peers) {
    this.host = host;
    this.peers = peers;
  }

  /**
   * Replaces a listener that has come from a client, or that reggie has read from its log.
   *
   * @throws SecurityException if it is no listener, or is in another process than its client's
   *     others, and these are as many as may be
   */
  @Override
  public Object prepareProxy(Object proxy) throws RemoteException {
    if (!(proxy instanceof RemoteEventListener)) {
      throw new SecurityException(
          "the lookup service got a "
              + proxy.getClass().getName()
              + " as listener; export a RemoteEventListener and send its proxy");
    }
    ClientAddress client = client(proxy);
    RemoteEventListener listener = unwrapped((RemoteEventListener) proxy);
    return register(listener, client);
  }

  /** Reggie reads its log before it is exported; a client's own claims are not believed. */
  private synchronized ClientAddress client(Object proxy) {
    if (!isWatched && proxy instanceof RegistrarListener recovered) {
      return ClientAddress.of(recovered.client(), host);
    }
    return ClientAddress.ofCurrentCall(host);
  }

  private static RemoteEventListener unwrapped(RemoteEventListener listener) {
    return listener instanceof RegistrarListener wrapper ? wrapper.listener() : listener;
  }

  private synchronized RegistrarListener register(
      RemoteEventListener listener, ClientAddress client) {
    try {
      CallbackSlot place = peers.admit(client, listener);
      RegistrarListener made =
          new RegistrarListener(
              listener,
              client.host(),
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

  /** From now on places are kept, since {@link #retain} will be called each second. */
  synchronized void startTracking() {
    isWatched = true;
  }

  /**
   * Forgets those that are not registered any more: that were not there twice, since one that is
   * being registered is not there yet.
   *
   * @param live all that are; the very objects
   */
  synchronized void retain(Set<Object> live) {
    for (Iterator<Map.Entry<RegistrarListener, TrackedListener>> all =
            registered.entrySet().iterator();
        all.hasNext(); ) {
      Map.Entry<RegistrarListener, TrackedListener> each = all.next();
      RegistrarListener listener = each.getKey(); // the entry is gone with its removal
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
