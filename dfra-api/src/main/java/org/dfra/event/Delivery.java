package org.dfra.event;

import java.io.Serializable;
import java.time.Instant;

/**
 * An event on its way to one listener.
 *
 * @param module the module's path, {@code robot/name}
 * @param epoch counts the module's lives: it grows by one with each activation
 * @param sequence the event's number; the module's events are numbered without gap, through all its
 *     lives, so a gap is a loss
 * @param dropped events that this listener's own policy has dropped since its last delivery,
 *     because it was slow or wanted fewer
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
}
