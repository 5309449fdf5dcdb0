package org.dfra.attack.event;

import java.util.concurrent.TimeUnit;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.SensorImpl;
import org.dfra.example.thermometer.TemperatureReading;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.lifecycle.Readiness;
import org.dfra.time.Scheduler;

/** A thermometer that publishes ten readings a second. */
public final class PulseImpl extends SensorImpl implements Thermometer {

  private static final double RATE = 10;
  private static final long PERIOD_NANOS = (long) (TimeUnit.SECONDS.toNanos(1) / RATE);
  private static final double CELSIUS = 20;

  private final Scheduler scheduler;
  private volatile boolean isClosed;

  /** Called by the module's server. */
  public PulseImpl(ModuleContext context) {
    super(context, "Thermometer that publishes all the time", "DFRA", "1");
    this.scheduler = context.scheduler();
  }

  @Override
  protected void onStart() {
    transitionTo(Readiness.READY);
    next();
  }

  private void next() {
    Scheduler.ScheduledTask unused = scheduler.after(PERIOD_NANOS, this::publish);
  }

  private void publish() {
    if (!isClosed) {
      publish(new TemperatureReading(CELSIUS, clock().instant()));
      next();
    }
  }

  @Override
  protected void onClose() {
    isClosed = true;
  }

  @Override
  public double updateRate() {
    return RATE;
  }

  @Override
  public double celsius() {
    return CELSIUS;
  }
}
