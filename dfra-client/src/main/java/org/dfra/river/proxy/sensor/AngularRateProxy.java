package org.dfra.river.proxy.sensor;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.AngularRateSensor;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a rate gyro. */
public final class AngularRateProxy extends SensorProxy<AngularRateSensor>
    implements AngularRateSensor {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public AngularRateProxy(RemoteModule server, UUID id, Identification identification) {
    super(AngularRateSensor.class, server, id, identification);
  }

  @Override
  public AngularRate rate() throws RemoteException {
    return target().rate();
  }
}
