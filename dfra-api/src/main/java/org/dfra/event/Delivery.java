package org.dfra.event;

import java.io.Serial;
import java.io.Serializable;
import java.time.Instant;

/**
 * The delivery of an event to one listener.
 *
 * @param module the module's path, {@code robot/name}
 * @param epoch counts the module's activations
 * @param sequence the event's sequence number among the module's events of its kind. Numbers are
 *     consecutive across restarts, so a gap means a loss
 * @param dropped events that this listener's own policy has dropped since its last delivery,
 *     because the listener was slow or its rate is limited; their sequence numbers are missing too
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

  /** A copy with this many more dropped events; this object if there are none. */
  public Delivery afterDropping(long more) {
    return more == 0
        ? this
        : new Delivery(module, epoch, sequence, dropped + more, published, event);
  }

  /** The kind of the event. */
  public DeliveryPolicy.EventKind kind() {
    return DeliveryPolicy.EventKind.of(event);
  }

  @Serial
  private Object writeReplace() {
    return new DeliveryForm(this);
  }
}
