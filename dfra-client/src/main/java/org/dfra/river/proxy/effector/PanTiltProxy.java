package org.dfra.river.proxy.effector;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.effector.PanTiltCommand;
import org.dfra.flow.effector.PanTiltEffector;
import org.dfra.flow.effector.PanTiltState;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a pan-tilt unit. */
public final class PanTiltProxy extends EffectorProxy<PanTiltCommand, PanTiltEffector>
    implements PanTiltEffector {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public PanTiltProxy(RemoteModule server, UUID id, Identification identification) {
    super(PanTiltEffector.class, server, id, identification);
  }

  @Override
  public PanTiltState panTiltState() throws RemoteException {
    return target().panTiltState();
  }
}
