package org.dfra.river.proxy.effector;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.effector.DriveCommand;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.DriveState;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a drive. */
public final class DriveProxy extends EffectorProxy<DriveCommand, DriveEffector>
    implements DriveEffector {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public DriveProxy(RemoteModule server, UUID id, Identification identification) {
    super(DriveEffector.class, server, id, identification);
  }

  @Override
  public DriveState driveState() throws RemoteException {
    return target().driveState();
  }
}
