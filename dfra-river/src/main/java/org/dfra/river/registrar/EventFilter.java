package org.dfra.river.registrar;

import net.jini.core.event.RemoteEvent;
import org.jspecify.annotations.Nullable;

/**
 * What the owner of a listener sees of a lookup service's events. Called by one thread at a time,
 * in the order of the events.
 */
public interface EventFilter {

  /**
   * The filter of the listener that is being registered by the call that this thread executes.
   * Reggie, which prepares the listener on this thread, passes nothing on. Empty if its owner sees
   * everything for ever.
   */
  ThreadLocal<@Nullable EventFilter> CURRENT = new ThreadLocal<>();

  /**
   * What the listener gets for an event.
   *
   * @return the event itself if nothing is hidden; null if the listener gets nothing
   */
  @Nullable RemoteEvent filtered(RemoteEvent event);
}
