package org.dfra.river.contract;

import java.util.UUID;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.river.proxy.effector.DriveProxy;
import org.dfra.river.server.effector.DriveServer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;

/** The proxy in the virtual machine of its effector, where it calls the implementation. */
class EffectorSameVmProxyContractTest extends EffectorContract {

  private DriveServer server;
  private DriveProxy proxy;

  @BeforeEach
  void serve() throws Exception {
    UUID id = UUID.randomUUID();
    server = ServedDrive.serve(id, ScriptedDrive.class);
    proxy = ServedDrive.near(server, id);
  }

  @AfterEach
  @Override
  void end() {
    server.close();
  }

  @Override
  DriveEffector effector() {
    return proxy;
  }

  @Override
  ScriptedDrive driver() {
    return ScriptedDrive.last(PATH);
  }

  @Override
  String commander() {
    return "a module in its own virtual machine";
  }
}
