package org.dfra.core.module;

import org.dfra.flow.sensor.Sensor;

/** Base of every sensor's driver. */
public abstract class SensorImpl extends ModuleImpl implements Sensor {

  /** See {@link ModuleImpl#ModuleImpl}. */
  protected SensorImpl(ModuleContext context, String description, String author, String version) {
    super(context, description, author, version);
  }

  /** {@inheritDoc} A local caller never sees a {@code RemoteException}. */
  @Override
  public abstract double updateRate();
}
