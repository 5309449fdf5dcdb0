package org.dfra.river.server;

import java.io.IOException;
import java.io.Serializable;
import java.net.Socket;
import java.rmi.server.RMIClientSocketFactory;

/**
 * The former name of {@link JrmpSocketFactory}, in stubs that lookup services stored or that robots
 * with an earlier release send; until the next release.
 *
 * @param host as there
 * @param deadlineMillis as there
 */
record JrmpSockets(String host, int deadlineMillis)
    implements RMIClientSocketFactory, Serializable {

  private Object readResolve() {
    return new JrmpSocketFactory(host, deadlineMillis);
  }

  @Override
  public Socket createSocket(String ignored, int port) throws IOException {
    return new JrmpSocketFactory(host, deadlineMillis).createSocket(ignored, port);
  }
}
