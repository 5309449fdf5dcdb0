package org.dfra.river.proxy.sensor;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a satellite positioning receiver. */
public final class GPSProxy extends SensorProxy<GPSSensor> implements GPSSensor {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public GPSProxy(RemoteModule server, UUID id, Identification identification) {
    super(GPSSensor.class, server, id, identification);
  }

  @Override
  public GpsFix fix() throws RemoteException {
    return target().fix();
  }

  @Override
  public LocationReading location() throws RemoteException {
    return target().location();
  }

  @Override
  public TimeReading time() throws RemoteException {
    return target().time();
  }
}
