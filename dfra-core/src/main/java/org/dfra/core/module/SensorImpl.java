package org.dfra.core.module;

import java.util.List;
import org.dfra.flow.sensor.Sensor;
import org.dfra.module.Precondition;
import org.dfra.persona.Attributes;

/** Base of every sensor's driver. A sensor begins a chain; see {@link DeviceImpl}. */
public abstract class SensorImpl extends DeviceImpl implements Sensor {

  /**
   * A sensor without declared output types and preconditions; see {@link ModuleImpl#ModuleImpl}.
   */
  protected SensorImpl(ModuleContext context, String description, String author, String version) {
    this(context, description, author, version, List.of(), List.of());
  }

  /**
   * See {@link ModuleImpl#ModuleImpl}.
   *
   * @param outputTypes the types of its readings, by the simple names of their classes
   * @param preconditions the required conditions of its environment
   */
  protected SensorImpl(
      ModuleContext context,
      String description,
      String author,
      String version,
      List<String> outputTypes,
      List<Precondition> preconditions) {
    super(context, description, author, version, List.of(), outputTypes, preconditions);
  }

  /** {@inheritDoc} A local call never throws a {@code RemoteException}. */
  @Override
  public abstract double updateRate();

  /** {@inheritDoc} Empty by default. */
  @Override
  protected List<? extends Attributes> deviceAttributes() {
    return List.of();
  }
}
