package org.dfra.river.proxy.sensor;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.sensor.Sensor;
import org.dfra.module.Identification;
import org.dfra.river.proxy.DeviceProxy;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/**
 * Smart proxy of a sensor.
 *
 * @param <S> the sensor's interface
 */
public abstract class SensorProxy<S extends Sensor> extends DeviceProxy<S> implements Sensor {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  protected SensorProxy(
      Class<S> kind, RemoteModule server, UUID id, Identification identification) {
    super(kind, server, id, identification);
  }

  @Override
  public final double updateRate() throws RemoteException {
    return target().updateRate();
  }
}
