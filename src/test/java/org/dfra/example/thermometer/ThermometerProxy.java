package org.dfra.example.thermometer;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.module.Identification;
import org.dfra.river.proxy.sensor.SensorProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a thermometer. */
public final class ThermometerProxy extends SensorProxy<Thermometer> implements Thermometer {

  private static final long serialVersionUID = 1L;

  /** Called by the module's server. */
  public ThermometerProxy(RemoteModule server, UUID id, Identification identification) {
    super(Thermometer.class, server, id, identification);
  }

  @Override
  public double celsius() throws RemoteException {
    return target().celsius();
  }
}
