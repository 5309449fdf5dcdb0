package org.dfra.river.server.effector;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import org.dfra.flow.effector.DriveCommand;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.DriveState;
import org.dfra.river.remote.effector.RemoteDriveEffector;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a drive. */
public final class DriveServer extends EffectorServer<DriveCommand, DriveEffector>
    implements RemoteDriveEffector {

  /** See {@link ModuleServer#ModuleServer}. */
  public DriveServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(DriveEffector.class, id, data);
  }

  @Override
  public DriveState driveState() throws RemoteException {
    return module().driveState();
  }
}
