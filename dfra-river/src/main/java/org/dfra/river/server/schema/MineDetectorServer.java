package org.dfra.river.server.schema;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import org.dfra.flow.perceptual.MineDetector;
import org.dfra.flow.perceptual.MinePercept;
import org.dfra.river.remote.schema.RemoteMineDetector;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a mine detector. */
public final class MineDetectorServer extends SchemaServer<MineDetector>
    implements RemoteMineDetector {

  /** See {@link ModuleServer#ModuleServer}. */
  public MineDetectorServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(MineDetector.class, id, data);
  }

  @Override
  public MinePercept mines() throws RemoteException {
    return module().mines();
  }
}
