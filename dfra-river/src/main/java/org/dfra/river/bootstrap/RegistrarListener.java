package org.dfra.river.bootstrap;

import java.io.InvalidObjectException;
import java.io.Serializable;
import net.jini.core.event.RemoteEvent;
import net.jini.core.event.RemoteEventListener;

/**
 * The former name of {@link QueuedEventListener}, in the logs of lookup services, which River reads
 * itself; until the next release.
 */
final class RegistrarListener implements RemoteEventListener, Serializable {

  private static final long serialVersionUID = 1L;

  @SuppressWarnings({"UnusedVariable", "NullAway.Init"}) // deserialized
  private RemoteEventListener listener;

  @SuppressWarnings({"UnusedVariable", "NullAway.Init"}) // deserialized
  private String client;

  private RegistrarListener() {}

  private Object readResolve() throws InvalidObjectException {
    return QueuedEventListener.recovered(listener, client);
  }

  @Override
  public void notify(RemoteEvent event) {
    throw new IllegalStateException("it is replaced when it is read");
  }
}
