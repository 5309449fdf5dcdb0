package org.dfra.directory;

import java.io.Serializable;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Identification;
import org.dfra.module.NotReadyException;

/** A module whose calls go where the test says; copies of it behave alike. */
record ListedGps(UUID id, String name) implements BareGps, Lamp, Serializable {

  /** What the calls of one module do. */
  static final class Behaviour {
    volatile RemoteException failure;
    volatile NotReadyException notReady;
    final AtomicInteger calls = new AtomicInteger();
  }

  private static final Map<UUID, Behaviour> BEHAVIOURS = new ConcurrentHashMap<>();

  Behaviour behaviour() {
    return BEHAVIOURS.computeIfAbsent(id, key -> new Behaviour());
  }

  private void call() throws RemoteException {
    behaviour().calls.incrementAndGet();
    RemoteException failure = behaviour().failure;
    if (failure != null) {
      throw failure;
    }
    NotReadyException notReady = behaviour().notReady;
    if (notReady != null) {
      throw notReady;
    }
  }

  @Override
  public void toggle() throws RemoteException {
    call();
  }

  @Override
  public String who() throws RemoteException {
    call();
    return name;
  }

  @Override
  public Identification identification() {
    return new Identification("robot", name, "a module of a test", "DFRA", "1");
  }

  @Override
  public Readiness readiness() {
    return Readiness.READY;
  }

  @Override
  public Readiness awaitReadiness(Duration patience) {
    return Readiness.READY;
  }

  @Override
  public double updateRate() {
    return 1;
  }

  @Override
  public GpsFix fix() throws RemoteException {
    call();
    return new GpsFix(GpsFix.Mode.NONE, null, Instant.EPOCH, 0, 0, 0, 0, 0);
  }

  @Override
  public LocationReading location() {
    return new LocationReading(new GeoPosition(0, 0, 0), name, Instant.EPOCH);
  }

  @Override
  public TimeReading time() {
    return new TimeReading(Instant.EPOCH, Instant.EPOCH);
  }
}
