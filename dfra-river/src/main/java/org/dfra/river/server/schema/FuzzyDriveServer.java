package org.dfra.river.server.schema;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import org.dfra.flow.motor.DriveAdvice;
import org.dfra.flow.motor.FuzzyDrive;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.perceptual.HeadingPercept;
import org.dfra.river.remote.schema.RemoteFuzzyDrive;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a fuzzy drive schema. */
public final class FuzzyDriveServer extends SchemaServer<FuzzyDrive> implements RemoteFuzzyDrive {

  /** See {@link ModuleServer#ModuleServer}. */
  public FuzzyDriveServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(FuzzyDrive.class, id, data);
  }

  @Override
  public DriveAdvice advise(Clearance clearance, HeadingPercept heading) throws RemoteException {
    return module().advise(clearance, heading);
  }
}
