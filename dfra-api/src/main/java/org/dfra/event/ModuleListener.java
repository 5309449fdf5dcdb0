package org.dfra.event;

import java.rmi.RemoteException;

/**
 * Is told a module's events, one at a time, in order, on a thread of its own.
 *
 * <p>A listener may be far away, so telling it may fail; one that fails or throws is told the next
 * event all the same.
 */
@FunctionalInterface
public interface ModuleListener {

  /** Something happened. */
  void notify(Delivery delivery) throws RemoteException;
}
