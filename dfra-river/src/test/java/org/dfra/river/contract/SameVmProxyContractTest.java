package org.dfra.river.contract;

import java.util.UUID;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.river.proxy.sensor.GPSProxy;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.server.sensor.GPSServer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;

/** The proxy in the virtual machine of its module, where it calls the implementation. */
class SameVmProxyContractTest extends ModuleContract {

  private GPSServer server;
  private GPSProxy proxy;

  @BeforeEach
  void serve() throws Exception {
    UUID id = UUID.randomUUID();
    server = Served.serve(id, null, null);
    proxy = Served.proxy((RemoteModule) server.getProxy(), id, server);
  }

  @AfterEach
  void end() {
    server.close();
  }

  @Override
  GPSSensor module() {
    return proxy;
  }

  @Override
  ScriptedGps driver() {
    return ScriptedGps.last(PATH);
  }
}
