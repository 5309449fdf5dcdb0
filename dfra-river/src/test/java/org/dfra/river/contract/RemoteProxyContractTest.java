package org.dfra.river.contract;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.util.UUID;
import org.dfra.event.DeliveryPolicy;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.river.proxy.sensor.GPSProxy;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.server.sensor.GPSServer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * The proxy far from its module: it has travelled, and knows its module by another identity, so
 * that every call goes over JERI.
 */
class RemoteProxyContractTest extends ModuleContract {

  private GPSServer server;
  private GPSProxy proxy;

  @BeforeEach
  void serve() throws Exception {
    server = Served.serve(UUID.randomUUID(), null, null);
    proxy = travelled(Served.proxy((RemoteModule) server.getProxy(), UUID.randomUUID(), server));
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

  @Test
  void aServerRefusesAListenerThatIsNotRemote() {
    assertThatThrownBy(
            () -> server.subscribe(new RecordingListener(), DeliveryPolicy.latestReading()))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            PATH
                + " cannot notify a RecordingListener, which is not a RemoteModuleListener; subscribe"
                + " through the module's proxy");
  }

  private static GPSProxy travelled(GPSProxy proxy) throws Exception {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(proxy);
    }
    try (ObjectInputStream in =
        new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
      return (GPSProxy) in.readObject();
    }
  }
}
