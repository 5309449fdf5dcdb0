package org.dfra.river.contract;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.dfra.core.module.Examinations.Finding;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ParameterTable.Range;
import org.dfra.core.module.SensorImpl;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.geometry.GeoPosition;
import org.dfra.module.Precondition;
import org.dfra.module.Readiness;

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
    declared()
        .number("rate", "between positions", Range.whole(1, 255, "s"), () -> rate, r -> rate = r);
    declared().show("serial", "its serial number", () -> "42");
    examinations().test("quick", () -> new Finding(true, "it is quick"));
    examinations()
        .test(
            "slow",
            () -> {
              // longer than any call may last, which is what is tested
              LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(2500));
              return new Finding(false, "it was slow");
            });
    examinations()
        .test(
            "broken",
            () -> {
              throw new IllegalStateException("no such wire");
            });
    examinations()
        .recovery(
            "kick",
            () -> {
              become(Readiness.FAILED, "it was kicked");
              become(Readiness.INITIALIZING);
              become(Readiness.READY);
              return new Finding(true, "it runs again");
            });
    LAST.put(context.path(), this);
  }

  /** The one that was made last under this path. */
  static ScriptedGps last(String path) {
    return LAST.get(path);
  }

  @Override
  protected void onStart() {
    become(Readiness.READY);
  }

  @Override
  protected void onClose() {}

  @Override
  protected void onClients(int number) {
    clients = number;
  }

  /** A satellite solution comes in. */
  void solve(double latitude) {
    position = new GeoPosition(latitude, 7, 50);
    tell(fix());
  }

  void lose() {
    become(Readiness.INITIALIZING, "its cable was cut");
  }

  void find() {
    become(Readiness.READY);
  }

  void stumble() {
    survived(new IllegalStateException("garbage on the line"));
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
