package org.dfra.river.server;

import java.rmi.RemoteException;
import java.util.List;
import java.util.concurrent.ThreadLocalRandom;
import java.util.function.BooleanSupplier;
import org.dfra.event.Delivery;
import org.dfra.event.delivery.BatchListener;
import org.dfra.river.remote.RemoteModuleListener;

/**
 * The calls to one remote listener. Each that succeeds renews the lease of the subscription, and
 * the next one tells the listener so.
 *
 * <p>Confined to the listener's queue, which makes one call at a time.
 */
final class ListenerCalls implements BatchListener {

  private final RemoteModuleListener listener;
  private final BooleanSupplier renewal;
  private long call = ThreadLocalRandom.current().nextLong();
  private long renewed;
  private boolean any; // whether a call has renewed the lease

  /**
   * @param listener calls on it have a deadline
   * @param renewal renews the lease; false if it has ended
   */
  ListenerCalls(RemoteModuleListener listener, BooleanSupplier renewal) {
    this.listener = listener;
    this.renewal = renewal;
  }

  /** One event is sent without a list, whose description would take part of its bytes. */
  @Override
  public void notify(List<Delivery> deliveries) throws RemoteException {
    call++;
    long last = any ? renewed : call;
    if (deliveries.size() == 1) {
      listener.notify(deliveries.get(0), call, last);
    } else {
      listener.notify(deliveries, call, last);
    }
    if (renewal.getAsBoolean()) {
      renewed = call;
      any = true;
    }
  }
}
