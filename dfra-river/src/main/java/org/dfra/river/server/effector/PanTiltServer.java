package org.dfra.river.server.effector;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import org.dfra.flow.effector.PanTiltCommand;
import org.dfra.flow.effector.PanTiltEffector;
import org.dfra.flow.effector.PanTiltState;
import org.dfra.river.remote.effector.RemotePanTiltEffector;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a pan-tilt unit. */
public final class PanTiltServer extends EffectorServer<PanTiltCommand, PanTiltEffector>
    implements RemotePanTiltEffector {

  /** See {@link ModuleServer#ModuleServer}. */
  public PanTiltServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(PanTiltEffector.class, id, data);
  }

  @Override
  public PanTiltState panTiltState() throws RemoteException {
    return module().panTiltState();
  }
}
