package org.dfra.river.proxy.sensor;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.OdometrySensor;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of an odometry sensor. */
public final class OdometryProxy extends SensorProxy<OdometrySensor> implements OdometrySensor {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public OdometryProxy(RemoteModule server, UUID id, Identification identification) {
    super(OdometrySensor.class, server, id, identification);
  }

  @Override
  public Odometry odometry() throws RemoteException {
    return target().odometry();
  }
}
