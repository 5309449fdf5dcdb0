package org.dfra.river.proxy.sensor;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.flow.sensor.RangeSensor;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a range sensor. */
public final class RangeProxy extends SensorProxy<RangeSensor> implements RangeSensor {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public RangeProxy(RemoteModule server, UUID id, Identification identification) {
    super(RangeSensor.class, server, id, identification);
  }

  @Override
  public RangeScan scan() throws RemoteException {
    return target().scan();
  }
}
