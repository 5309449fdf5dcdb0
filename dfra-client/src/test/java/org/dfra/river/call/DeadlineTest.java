package org.dfra.river.call;

import net.jini.jeri.Endpoint;
import net.jini.jeri.ServerEndpoint;
import org.dfra.river.transport.TransportServerEndpoint;

/** Deadlines over TCP. */
class DeadlineTest extends DeadlineContract {

  @Override
  ServerEndpoint endpoint() {
    return new TransportServerEndpoint("127.0.0.1", 0);
  }

  @Override
  Endpoint client(int port) {
    return Endpoints.tcpClient("127.0.0.1", port);
  }
}
