package org.dfra.river.transport;

import net.jini.jeri.ServerEndpoint;

class TcpTransportTest extends TransportContract {

  @Override
  boolean finishesCalls() {
    return true;
  }

  @Override
  ServerEndpoint serverEndpoint() {
    return new TransportServerEndpoint(HOST, 0);
  }
}
