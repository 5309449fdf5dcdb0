package org.dfra.drivers.gps;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.persona.Attributes;
import org.dfra.persona.GpsReceiverAttributes;
import org.dfra.persona.LocationAttributes;
import org.dfra.persona.SensorAttributes;
import org.jspecify.annotations.Nullable;

/** The attributes by which clients find a receiver. */
public final class GpsReceiverPersona {

  /** The published location is kept until the receiver is this far from it, metres. */
  private static final double MOVED = 10;

  /** Or until it has this age, whichever comes first. */
  private static final Duration OLD = Duration.ofSeconds(30);

  private final SensorAttributes sensor;
  private volatile @Nullable LocationAttributes reported; // written by the reader

  /**
   * @param sensor how it measures
   */
  public GpsReceiverPersona(SensorAttributes sensor) {
    this.sensor = sensor;
  }

  /**
   * All attributes; the location follows the receiver with some delay.
   *
   * @param receiver its identity
   */
  public List<Attributes> all(GpsReceiverAttributes receiver) {
    List<Attributes> all = new ArrayList<>(List.of(sensor, receiver));
    @Nullable LocationAttributes where = reported;
    if (where != null) {
      all.add(where);
    }
    return all;
  }

  /** Updates the location; on the reader thread, so that queries have no side effects. */
  public void located(LocationReading now) {
    @Nullable LocationAttributes last = reported;
    if (last == null
        || Duration.between(last.measured(), now.measured()).abs().compareTo(OLD) > 0
        || last.position().groundDistance(now.position()) > MOVED) {
      reported = new LocationAttributes(now.position(), now.measured());
    }
  }
}
