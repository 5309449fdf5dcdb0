package org.dfra.river.proxy.schema;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.perceptual.MineDetector;
import org.dfra.flow.perceptual.MinePercept;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a mine detector. */
public final class MineDetectorProxy extends SchemaProxy<MineDetector> implements MineDetector {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public MineDetectorProxy(RemoteModule server, UUID id, Identification identification) {
    super(MineDetector.class, server, id, identification);
  }

  @Override
  public MinePercept mines() throws RemoteException {
    return target().mines();
  }
}
