package org.dfra.event;

import java.io.Serializable;
import java.time.Instant;

/**
 * An event on its way to one listener.
 *
 * @param module the module's path, {@code robot/name}
 * @param epoch counts the module's lives: it grows by one with each activation
 * @param sequence the event's number among the module's events of its kind; they are numbered
 *     without gap, through all its lives, so a gap between two of a kind is a loss
 * @param dropped events that this listener's own policy has dropped since its last delivery,
 *     because it was slow or wanted fewer; they are missing in the sequence too
 * @param published when the module published it, by its own clock
 * @param event what happened
 */
public record Delivery(
    String module, long epoch, long sequence, long dropped, Instant published, ModuleEvent event)
    implements Serializable {

  public Delivery {
    if (epoch < 0 || sequence < 0 || dropped < 0) {
      throw new IllegalArgumentException(
          "a delivery of "
              + module
              + " has epoch "
              + epoch
              + ", sequence "
              + sequence
              + " and dropped "
              + dropped
              + "; none may be below 0");
    }
  }

  /** The same after so many more dropped events; itself where there are none. */
  public Delivery afterDropping(long more) {
    return more == 0
        ? this
        : new Delivery(module, epoch, sequence, dropped + more, published, event);
  }

  /** The kind of the event. */
  public DeliveryPolicy.EventKind kind() {
    return DeliveryPolicy.EventKind.of(event);
  }
}
