package org.dfra.river.contract;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.rmi.MarshalledObject;
import java.util.List;
import java.util.UUID;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.SourceLocation;
import org.dfra.river.proxy.effector.DriveProxy;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.dfra.river.server.effector.DriveServer;

/** A scripted drive, served in this virtual machine as a group would serve it. */
final class ServedDrive {

  private ServedDrive() {}

  static DriveServer serve(UUID id, Class<?> driver) throws Exception {
    ModuleDescription description =
        new ModuleDescription(
            "atrv1",
            "drive",
            DriveServer.class.getName(),
            DriveProxy.class.getName(),
            driver.getName(),
            null,
            false,
            EffectorContract.PARAMETERS,
            SourceLocation.CODE);
    return ModuleServer.started(
        new DriveServer(
            null,
            new MarshalledObject<>(
                new ModuleActivation(
                    description,
                    id,
                    java.time.Instant.now(),
                    "127.0.0.1",
                    List.of(),
                    List.of(),
                    null))));
  }

  /** The proxy beside its module, where it calls the implementation. */
  static DriveProxy near(DriveServer server, UUID id) throws Exception {
    return new DriveProxy((RemoteModule) server.getProxy(), id, server.identification());
  }

  /** A proxy that has travelled, and knows its module by another identity: every call is JERI's. */
  static DriveProxy far(DriveServer server) throws Exception {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(near(server, UUID.randomUUID()));
    }
    try (ObjectInputStream in =
        new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
      return (DriveProxy) in.readObject();
    }
  }
}
