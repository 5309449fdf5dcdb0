package org.dfra.event;

import java.rmi.RemoteException;

/**
 * Is told a module's events, one at a time, in order, on a thread that is not the module's.
 *
 * <p>A listener may take its time: it delays itself only, and what its {@link DeliveryPolicy} does
 * not keep for it meanwhile is dropped and counted. One that throws is told the next event all the
 * same.
 */
@FunctionalInterface
public interface ModuleListener {

  /** Something happened. */
  void notify(Delivery delivery) throws RemoteException;
}
