package org.dfra.river.proxy.sensor;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.LocalGPSSensor;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;
import org.jspecify.annotations.Nullable;

/**
 * Heavyweight proxy of a satellite positioning receiver: it converts positions itself, in the
 * client's virtual machine, and requests only the location from the server. Any GPS server can use
 * this proxy, by its module's properties.
 */
public final class LocalCoordinatesGPSProxy extends SensorProxy<GPSSensor>
    implements LocalGPSSensor {

  private static final long serialVersionUID = 1L;

  /** For the last requested datum; a client seldom uses two. */
  private transient volatile @Nullable LocalFrame frame;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public LocalCoordinatesGPSProxy(RemoteModule server, UUID id, Identification identification) {
    super(GPSSensor.class, server, id, identification);
  }

  @Override
  public LocalPosition localPosition(GeoPosition datum) throws RemoteException {
    @Nullable LocalFrame known = frame;
    if (known == null || !known.datum().equals(datum)) {
      known = new LocalFrame(datum);
      frame = known;
    }
    return known.toLocal(target().location().position());
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
