package org.dfra.river.contract;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ParameterTable.NumberRange;
import org.dfra.core.module.SensorImpl;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Precondition;

/** A receiver whose satellites are the test. */
public final class ScriptedGps extends SensorImpl implements GPSSensor {

  private static final Map<String, ScriptedGps> LAST = new ConcurrentHashMap<>();

  volatile int clients = -1;
  private volatile double rate = 1;
  private volatile GeoPosition position = new GeoPosition(52, 7, 50);

  public ScriptedGps(ModuleContext context) {
    super(
        context,
        "a scripted receiver",
        "DFRA",
        "1",
        List.of("GpsFix"),
        List.of(new Precondition("temperature", -40, 85, "°C")));
    parameterTable()
        .declareNumber(
            "rate",
            "between positions",
            NumberRange.isInteger(1, 255, "s"),
            () -> rate,
            r -> rate = r);
    parameterTable().declareReadOnly("serial", "its serial number", () -> "42");
    diagnostics().addTest("quick", () -> new DiagnosticFinding(true, "it is quick"));
    diagnostics()
        .addTest(
            "slow",
            () -> {
              // longer than any call may last, which is what is tested
              LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(2500));
              return new DiagnosticFinding(false, "it was slow");
            });
    diagnostics()
        .addTest(
            "broken",
            () -> {
              throw new IllegalStateException("no such wire");
            });
    diagnostics()
        .addRecovery(
            "kick",
            () -> {
              transitionTo(Readiness.FAILED, "it was kicked");
              transitionTo(Readiness.INITIALIZING);
              transitionTo(Readiness.READY);
              return new DiagnosticFinding(true, "it runs again");
            });
    LAST.put(context.path(), this);
  }

  /** The one that was made last under this path. */
  static ScriptedGps last(String path) {
    return LAST.get(path);
  }

  @Override
  protected void onStart() {
    transitionTo(Readiness.READY);
  }

  @Override
  protected void onClose() {}

  @Override
  protected void onClientCount(int number) {
    clients = number;
  }

  /** A satellite solution comes in. */
  void solve(double latitude) {
    position = new GeoPosition(latitude, 7, 50);
    publish(fix());
  }

  void lose() {
    transitionTo(Readiness.INITIALIZING, "its cable was cut");
  }

  void find() {
    transitionTo(Readiness.READY);
  }

  void stumble() {
    recordException(new IllegalStateException("garbage on the line"));
  }

  @Override
  public double updateRate() {
    return 1 / rate;
  }

  @Override
  public GpsFix fix() {
    return new GpsFix(GpsFix.Mode.FIX_3D, position, Instant.EPOCH, 0, 0, 1, 9, 9);
  }

  @Override
  public LocationReading location() {
    return new LocationReading(position, frame(), Instant.EPOCH);
  }

  @Override
  public TimeReading time() {
    return new TimeReading(Instant.EPOCH, Instant.EPOCH);
  }
}
