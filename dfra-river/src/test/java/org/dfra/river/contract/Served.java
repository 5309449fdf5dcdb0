package org.dfra.river.contract;

import java.rmi.MarshalledObject;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.river.proxy.sensor.GPSProxy;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.dfra.river.server.sensor.GPSServer;
import org.jspecify.annotations.Nullable;

/** A scripted receiver, served in this virtual machine as a group would serve it. */
final class Served {

  private Served() {}

  static GPSServer serve(UUID id, @Nullable String configuration, @Nullable String state)
      throws Exception {
    ModuleDescription description =
        new ModuleDescription(
            "atrv1",
            "gps_front",
            GPSServer.class.getName(),
            GPSProxy.class.getName(),
            ScriptedGps.class.getName(),
            configuration,
            false,
            Parameters.of(ModuleContract.PATH, Map.of()),
            SourceLocation.CODE);
    return ModuleServer.started(
        new GPSServer(
            null,
            new MarshalledObject<>(
                new ModuleActivation(
                    description,
                    id,
                    java.time.Instant.now(),
                    "127.0.0.1",
                    List.of(),
                    List.of(),
                    state))));
  }

  static GPSProxy proxy(RemoteModule stub, UUID id, GPSServer server) throws Exception {
    return new GPSProxy(stub, id, server.identification());
  }
}
