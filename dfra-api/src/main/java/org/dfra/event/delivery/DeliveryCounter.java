package org.dfra.event.delivery;

import java.rmi.RemoteException;
import java.util.Arrays;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.ModuleListener;

/**
 * Counts the events that a listener receives, and the lost ones by gaps in the sequence numbers. It
 * filters duplicates: an event that arrived before by another path is not passed on.
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

  /** @param listener receives the events that are not duplicates */
  public DeliveryCounter(ModuleListener listener) {
    this.listener = listener;
    Arrays.fill(last, NONE);
    Arrays.fill(first, NONE);
  }

  /**
   * Sets the sequence numbers to count from. Only the first call has an effect; later losses are
   * detected by the sequence numbers.
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
      } else { // some arrived before the registration's reply
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
      return false; // a duplicate, or overtaken
    } // else the numbers decreased: the module's host lost power, or its disk
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
