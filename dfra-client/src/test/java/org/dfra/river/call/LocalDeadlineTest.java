package org.dfra.river.call;

import net.jini.jeri.Endpoint;
import net.jini.jeri.ServerEndpoint;

/** Deadlines over a Unix-domain socket. */
class LocalDeadlineTest extends DeadlineContract {

  @Override
  ServerEndpoint endpoint() {
    return Endpoints.withLocalSocket("127.0.0.1", 0);
  }

  @Override
  Endpoint client(int port) {
    return Endpoints.tcpClient("127.0.0.1", port);
  }
}
