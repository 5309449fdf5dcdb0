package org.dfra.river.proxy.schema;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.motor.DriveAdvice;
import org.dfra.flow.motor.FuzzyDrive;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.perceptual.HeadingPercept;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a fuzzy drive schema. */
public final class FuzzyDriveProxy extends SchemaProxy<FuzzyDrive> implements FuzzyDrive {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public FuzzyDriveProxy(RemoteModule server, UUID id, Identification identification) {
    super(FuzzyDrive.class, server, id, identification);
  }

  @Override
  public DriveAdvice advise(Clearance clearance, HeadingPercept heading) throws RemoteException {
    return target().advise(clearance, heading);
  }
}
