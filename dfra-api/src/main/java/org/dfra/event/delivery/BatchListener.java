package org.dfra.event.delivery;

import java.rmi.RemoteException;
import java.util.List;
import org.dfra.event.Delivery;

/** Receives all events that wait in a {@link ListenerQueue} at once, such as by one remote call. */
@FunctionalInterface
public interface BatchListener {

  /**
   * Notifies the listener of events.
   *
   * @param deliveries at least one, in the order of their publication; unmodifiable
   * @throws RemoteException if it is unknown whether the listener has any of them: all count as
   *     dropped
   */
  void notify(List<Delivery> deliveries) throws RemoteException;
}
