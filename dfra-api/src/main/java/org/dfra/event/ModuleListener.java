package org.dfra.event;

import java.rmi.RemoteException;

/**
 * Receives a module's events, one at a time, in order, on a thread that is not the module's.
 *
 * <p>A slow listener delays only itself: events that its {@link DeliveryPolicy} does not keep
 * meanwhile are dropped and counted. A listener that throws still receives the next event.
 */
@FunctionalInterface
public interface ModuleListener {

  /** Notifies the listener of an event. */
  void notify(Delivery delivery) throws RemoteException;
}
