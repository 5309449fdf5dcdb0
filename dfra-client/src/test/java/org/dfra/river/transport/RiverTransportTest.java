package org.dfra.river.transport;

import net.jini.jeri.ServerEndpoint;
import net.jini.jeri.tcp.TcpServerEndpoint;

/** River's own transport, which the contract must suit. */
class RiverTransportTest extends TransportContract {

  @Override
  boolean finishesCalls() {
    return false;
  }

  @Override
  ServerEndpoint serverEndpoint() {
    return TcpServerEndpoint.getInstance(HOST, 0);
  }
}
