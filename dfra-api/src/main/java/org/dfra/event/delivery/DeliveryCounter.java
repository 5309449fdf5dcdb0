package org.dfra.event.delivery;

import java.rmi.RemoteException;
import java.util.Arrays;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.ModuleListener;

/**
 * Counts what reaches a listener, and by the gaps in the numbers what does not. Passes nothing on
 * twice: an event that came by another way before is left out.
 */
public final class DeliveryCounter implements ModuleListener {

  private static final long NONE = -1;

  private final ModuleListener listener;
  private final long[] last = new long[EventKind.values().length];
  private final long[] first = new long[EventKind.values().length];
  private final long[] epochs = new long[EventKind.values().length];
  private boolean begun;
  private long received;
  private long lost;

  /**
   * @param listener is told what is new
   */
  public DeliveryCounter(ModuleListener listener) {
    this.listener = listener;
    Arrays.fill(last, NONE);
    Arrays.fill(first, NONE);
  }

  /**
   * Says from where to count. Only the first time counts: later on, what is missing is seen by the
   * numbers.
   *
   * @param lastSequences the last number of each kind before the listener was registered, by
   *     ordinal
   */
  public synchronized void startAfter(long[] lastSequences) {
    if (begun) {
      return;
    }
    begun = true;
    for (int kind = 0; kind < last.length; kind++) {
      if (last[kind] == NONE) {
        last[kind] = lastSequences[kind];
      } else { // some came before the registration's own answer
        lost += Math.max(0, first[kind] - lastSequences[kind] - 1);
      }
    }
  }

  @Override
  public void notify(Delivery delivery) throws RemoteException {
    if (count(delivery)) {
      listener.notify(delivery);
    }
  }

  private synchronized boolean count(Delivery delivery) {
    int kind = delivery.kind().ordinal();
    long number = delivery.sequence();
    if (last[kind] == NONE) {
      first[kind] = number;
    } else if (number > last[kind]) {
      lost += number - last[kind] - 1;
    } else if (delivery.epoch() == epochs[kind]) {
      return false; // a second time, or overtaken
    } // else the numbers fell back: the module's host lost power, or its disk
    last[kind] = number;
    epochs[kind] = delivery.epoch();
    received++;
    return true;
  }

  /** Events that reached the listener. */
  public synchronized long received() {
    return received;
  }

  /** Events that did not. */
  public synchronized long lost() {
    return lost;
  }
}
