package org.dfra.example.thermometer;

import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.SensorImpl;
import org.dfra.lifecycle.Readiness;

/**
 * A thermometer in a room whose temperature never changes. Parameter {@code celsius}: that
 * temperature, default 20.
 */
public final class SteadyThermometerImpl extends SensorImpl implements Thermometer {

  private final double celsius;

  /** Called by the module's server. */
  public SteadyThermometerImpl(ModuleContext context) {
    super(context, "Thermometer in a steady room", "you", "1.0");
    this.celsius = settings().number("celsius", 20, -273.15, 1000);
  }

  @Override
  protected void onStart() {
    transitionTo(Readiness.READY);
  }

  @Override
  protected void onClose() {}

  @Override
  public double updateRate() {
    return 0;
  }

  @Override
  public double celsius() {
    return celsius;
  }
}
