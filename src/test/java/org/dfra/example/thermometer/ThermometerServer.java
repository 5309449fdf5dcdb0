package org.dfra.example.thermometer;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.sensor.SensorServer;

/** Activatable server of a thermometer. */
public final class ThermometerServer extends SensorServer<Thermometer>
    implements RemoteThermometer {

  /** Called by the activation system. */
  public ThermometerServer(ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(Thermometer.class, id, data);
  }

  @Override
  public double celsius() throws RemoteException {
    return module().celsius();
  }
}
