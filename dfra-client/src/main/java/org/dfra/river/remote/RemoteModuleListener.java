package org.dfra.river.remote;

import java.rmi.Remote;
import java.rmi.RemoteException;
import java.util.List;
import org.dfra.event.Delivery;
import org.dfra.event.ModuleListener;

/**
 * A listener that is notified over the network. Clients need not implement it: proxies do.
 *
 * <p>A server numbers its calls to a listener. When one has succeeded, the server renews the lease
 * of the subscription, and names that call in the next one. So a listener knows, without a call of
 * its own, that its lease was renewed not before it received the named call.
 */
public interface RemoteModuleListener extends ModuleListener, Remote {

  /** The most events that a server delivers in one call. */
  int MAX_EVENTS = 64;

  /**
   * Notifies the listener of one event.
   *
   * @param call the number of this call. Numbers of a subscription ascend from a random one, so
   *     that they differ from those of an earlier subscription
   * @param renewed number of the last call of this subscription after which its lease was renewed;
   *     {@code call} if there is none
   */
  default void notify(Delivery delivery, long call, long renewed) throws RemoteException {
    notify(delivery);
  }

  /**
   * Notifies the listener of several events: all that wait for it, within the server's limits. The
   * events after one at which it throws are delivered nevertheless; then the first exception is
   * thrown, with the others as suppressed ones. To the server, such a call has failed, and all its
   * events count as dropped.
   *
   * @param deliveries 1 to {@value #MAX_EVENTS}, in the order of their publication
   * @param call as above
   * @param renewed as above
   * @throws IllegalArgumentException if {@code deliveries} are not such a list; then none is
   *     delivered
   */
  default void notify(List<Delivery> deliveries, long call, long renewed) throws RemoteException {
    DeliveryList.notifyOfEach(this, DeliveryList.checked(deliveries));
  }
}
