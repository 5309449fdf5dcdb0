package org.dfra.drivers.gps.m12;

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

/** What an M12+ says of itself to those who look for one. */
final class M12Attributes {

  /** A told location is kept until the receiver is this far from it, in metres. */
  private static final double MOVED = 10;

  /** Or until it is this old, whichever comes first. */
  private static final Duration OLD = Duration.ofSeconds(30);

  private static final ChainAttributes CHAIN =
      new ChainAttributes(List.of(), List.of("GpsFix", "LocationReading", "TimeReading"));

  /** The receiver's rate is 1 Hz to one position in 255 s; user's guide, message @@Ha. */
  private static final SensorAttributes SENSOR =
      new SensorAttributes(
          "GpsFix",
          List.of("continuous"),
          1 / 255.0,
          1,
          null,
          List.of("The antenna sees the open sky."));

  private @Nullable LocationAttributes told; // guarded by this

  /**
   * @param receiver what the receiver said it is, if it has
   * @param channels how many satellites it can follow, if that is known
   * @param location where it is, if it knows
   * @param frame the antenna's frame
   * @param parent the frame it is mounted in
   * @param mount where it is mounted there
   */
  List<Attributes> all(
      @Nullable ReceiverIdentification receiver,
      @Nullable Integer channels,
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
    List<Attributes> all =
        new ArrayList<>(List.of(CHAIN, SENSOR, pose, device(receiver, channels)));
    @Nullable LocationAttributes where = location(location);
    if (where != null) {
      all.add(where);
    }
    return all;
  }

  private static GpsReceiverAttributes device(
      @Nullable ReceiverIdentification receiver, @Nullable Integer channels) {
    return receiver == null
        ? new GpsReceiverAttributes(null, null, null, null, channels, List.of("2D", "3D"))
        : new GpsReceiverAttributes(
            known(receiver.model()),
            known(receiver.serialNumber()),
            known(receiver.softwarePartNumber()),
            known(receiver.softwareVersion()),
            channels,
            List.of("2D", "3D"));
  }

  private static @Nullable String known(String text) {
    return text.isEmpty() ? null : text;
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
