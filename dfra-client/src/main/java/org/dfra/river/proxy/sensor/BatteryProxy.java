package org.dfra.river.proxy.sensor;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.sensor.BatterySensor;
import org.dfra.flow.sensor.BatteryState;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a battery's sensor. */
public final class BatteryProxy extends SensorProxy<BatterySensor> implements BatterySensor {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public BatteryProxy(RemoteModule server, UUID id, Identification identification) {
    super(BatterySensor.class, server, id, identification);
  }

  @Override
  public BatteryState battery() throws RemoteException {
    return target().battery();
  }
}
