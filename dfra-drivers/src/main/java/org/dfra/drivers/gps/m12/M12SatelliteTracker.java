package org.dfra.drivers.gps.m12;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dfra.drivers.gps.GpsReceiverProtocol.SatelliteInView;
import org.dfra.drivers.gps.m12.M12Message.VisibleSatellites;
import org.dfra.drivers.gps.m12.M12PositionMessage.SatelliteChannel;
import org.dfra.flow.sensor.GpsFix;
import org.jspecify.annotations.Nullable;

/**
 * Combines the data of satellites: {@code @@Bb} reports their directions, {@code @@Ha} and
 * {@code @@Ea} their signals. Confined to the reader thread.
 */
final class M12SatelliteTracker {

  private final Map<Integer, VisibleSatellites.VisibleSatellite> places = new LinkedHashMap<>();
  private final Map<Integer, SatelliteChannel> channels = new LinkedHashMap<>();
  private boolean solved;

  void forget() {
    places.clear();
    channels.clear();
  }

  List<SatelliteInView> with(VisibleSatellites visible) {
    places.clear();
    visible.satellites().forEach(place -> places.put(place.satellite(), place));
    return all();
  }

  /**
   * Adds the channels of a message.
   *
   * @param mode what was solved for
   */
  List<SatelliteInView> with(M12PositionMessage message, GpsFix.Mode mode) {
    solved = mode != GpsFix.Mode.NONE;
    channels.clear();
    for (SatelliteChannel channel : message.channels()) {
      if (channel.satellite() != 0) {
        channels.put(channel.satellite(), channel);
      }
    }
    return all();
  }

  private List<SatelliteInView> all() {
    List<SatelliteInView> all = new ArrayList<>();
    Map<Integer, VisibleSatellites.VisibleSatellite> silent = new HashMap<>(places);
    for (SatelliteChannel channel : channels.values()) {
      all.add(inView(channel.satellite(), channel, silent.remove(channel.satellite())));
    }
    places.keySet().stream()
        .filter(silent::containsKey)
        .forEach(number -> all.add(inView(number, null, silent.get(number))));
    return all;
  }

  private SatelliteInView inView(
      int number,
      @Nullable SatelliteChannel channel,
      VisibleSatellites.@Nullable VisibleSatellite place) {
    return new SatelliteInView(
        String.format("G%02d", number),
        place == null ? null : place.elevation(),
        place == null ? null : place.azimuth(),
        channel == null || channel.carrierToNoise() == 0 ? null : channel.carrierToNoise(),
        solved && channel != null && channel.isAvailable());
  }
}
