package org.dfra.drivers.gps;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.geometry.Transform;
import org.dfra.persona.Attributes;
import org.dfra.persona.ChainAttributes;
import org.dfra.persona.GpsReceiverAttributes;
import org.dfra.persona.LocationAttributes;
import org.dfra.persona.PoseAttributes;
import org.dfra.persona.SensorAttributes;
import org.jspecify.annotations.Nullable;

/** What a receiver says of itself to those who look for one. */
final class ReceiverAttributes {

  /** A told location is kept until the receiver is this far from it, in metres. */
  private static final double MOVED = 10;

  /** Or until it is this old, whichever comes first. */
  private static final Duration OLD = Duration.ofSeconds(30);

  private static final ChainAttributes CHAIN =
      new ChainAttributes(List.of(), List.of("GpsFix", "LocationReading", "TimeReading"));

  private final SensorAttributes sensor;
  private @Nullable LocationAttributes told; // guarded by this

  ReceiverAttributes(SensorAttributes sensor) {
    this.sensor = sensor;
  }

  /**
   * @param receiver what it is
   * @param location where it is, if it knows
   * @param frame the antenna's frame
   * @param parent the frame it is mounted in
   * @param mount where it is mounted there
   */
  List<Attributes> all(
      GpsReceiverAttributes receiver,
      @Nullable LocationReading location,
      String frame,
      String parent,
      Transform mount) {
    PoseAttributes pose =
        new PoseAttributes(
            frame,
            parent,
            mount.x(),
            mount.y(),
            mount.z(),
            mount.roll(),
            mount.pitch(),
            mount.yaw());
    List<Attributes> all = new ArrayList<>(List.of(CHAIN, sensor, pose, receiver));
    @Nullable LocationAttributes where = location(location);
    if (where != null) {
      all.add(where);
    }
    return all;
  }

  private synchronized @Nullable LocationAttributes location(@Nullable LocationReading now) {
    if (now == null) {
      return told;
    }
    @Nullable LocationAttributes last = told;
    if (last == null
        || Duration.between(last.measured(), now.measured()).abs().compareTo(OLD) > 0
        || last.position().groundDistance(now.position()) > MOVED) {
      told = new LocationAttributes(now.position(), now.measured());
    }
    return told;
  }
}
