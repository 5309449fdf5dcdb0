package org.dfra.river.proxy.effector;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.effector.FlightCommand;
import org.dfra.flow.effector.FlightEffector;
import org.dfra.flow.effector.FlightState;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a flight controller. */
public final class FlightProxy extends EffectorProxy<FlightCommand, FlightEffector>
    implements FlightEffector {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public FlightProxy(RemoteModule server, UUID id, Identification identification) {
    super(FlightEffector.class, server, id, identification);
  }

  @Override
  public FlightState flightState() throws RemoteException {
    return target().flightState();
  }
}
