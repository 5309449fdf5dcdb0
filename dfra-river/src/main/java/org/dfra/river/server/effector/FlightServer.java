package org.dfra.river.server.effector;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import org.dfra.flow.effector.FlightCommand;
import org.dfra.flow.effector.FlightEffector;
import org.dfra.flow.effector.FlightState;
import org.dfra.river.remote.effector.RemoteFlightEffector;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a flight controller. */
public final class FlightServer extends EffectorServer<FlightCommand, FlightEffector>
    implements RemoteFlightEffector {

  /** See {@link ModuleServer#ModuleServer}. */
  public FlightServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(FlightEffector.class, id, data);
  }

  @Override
  public FlightState flightState() throws RemoteException {
    return module().flightState();
  }
}
