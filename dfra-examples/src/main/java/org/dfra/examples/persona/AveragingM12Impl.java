package org.dfra.examples.persona;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Objects;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.SensorImpl;
import org.dfra.core.state.StateStore;
import org.dfra.drivers.gps.m12.M12PlusImpl;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.ModuleEvent;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.persona.Attributes;
import org.dfra.persona.ChainAttributes;
import org.dfra.persona.PoseAttributes;
import org.jspecify.annotations.Nullable;

/**
 * A newer version of a driver, to which the demonstration changes: an M12+ whose positions are the
 * mean of the last {@value #POSITIONS}, for a robot that is stopped. Parameters and attributes are
 * those of {@link M12PlusImpl}, which communicates with the device.
 */
public final class AveragingM12Impl extends SensorImpl implements GPSSensor {

  private static final int POSITIONS = 5;

  private final M12PlusImpl receiver;
  private final Deque<GeoPosition> last = new ArrayDeque<>(); // by the listener's thread
  private volatile @Nullable GpsFix mean;
  private volatile @Nullable Subscription subscription;

  /** Called by the module's server. */
  public AveragingM12Impl(ModuleContext context) {
    super(
        context,
        "M12+ GPS receiver, averaging positions",
        "DFRA",
        "1.1",
        List.of("GpsFix", "LocationReading", "TimeReading"),
        List.of());
    // History and event numbers are this module's; the wrapped driver keeps its own.
    this.receiver =
        new M12PlusImpl(
            new ModuleContext(
                context.robot(),
                context.name(),
                context.parameters(),
                context.clock(),
                StateStore.inMemory()));
  }

  @Override
  protected void onStart() {
    subscription =
        receiver.subscribe(
            this::received,
            DeliveryPolicy.keepLast(POSITIONS).withKinds(EventKind.READING, EventKind.READINESS));
    receiver.start();
  }

  @Override
  protected void onClose() {
    receiver.close();
    if (subscription != null) {
      subscription.close();
    }
  }

  private void received(Delivery delivery) {
    if (delivery.event() instanceof ModuleEvent.NewReading news
        && news.reading() instanceof GpsFix fix
        && fix.position() != null) {
      add(fix);
    } else if (delivery.event() instanceof ModuleEvent.ReadinessChanged change
        && !change.to().serves()
        && readiness().canTransitionTo(change.to())) {
      last.clear();
      transitionTo(change.to(), "its receiver is " + change.to());
    }
  }

  private void add(GpsFix fix) {
    last.addLast(Objects.requireNonNull(fix.position()));
    if (last.size() > POSITIONS) {
      last.removeFirst();
    }
    GpsFix averaged = fix.withPosition(mean());
    mean = averaged;
    if (readiness() == Readiness.INITIALIZING) {
      transitionTo(Readiness.READY);
    }
    publish(averaged);
  }

  /** The mean of each coordinate, for positions some metres apart and not at the antimeridian. */
  private GeoPosition mean() {
    return new GeoPosition(
        last.stream().mapToDouble(GeoPosition::latitude).average().orElseThrow(),
        last.stream().mapToDouble(GeoPosition::longitude).average().orElseThrow(),
        last.stream().mapToDouble(GeoPosition::height).average().orElseThrow());
  }

  @Override
  public GpsFix fix() {
    GpsFix fix = mean;
    if (fix == null || !readiness().serves()) {
      throw new NotReadyException(path(), readiness(), "its receiver has no position yet");
    }
    return fix;
  }

  @Override
  public LocationReading location() {
    GpsFix fix = fix();
    return new LocationReading(Objects.requireNonNull(fix.position()), frame(), fix.utc());
  }

  @Override
  public TimeReading time() {
    return receiver.time();
  }

  @Override
  public double updateRate() {
    return receiver.updateRate();
  }

  @Override
  protected List<Attributes> deviceAttributes() {
    return receiver.attributes().stream()
        .filter(each -> !(each instanceof ChainAttributes || each instanceof PoseAttributes))
        .toList();
  }
}
