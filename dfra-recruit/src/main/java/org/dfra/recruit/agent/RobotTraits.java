package org.dfra.recruit.agent;

import java.util.List;
import java.util.Optional;
import org.dfra.core.config.Parameters;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.jspecify.annotations.Nullable;

/**
 * Properties of a robot as a helper, from its description.
 *
 * @param percepts that it can observe; empty for one that only requests help
 * @param speed metres per second
 * @param detourFactor ratio of path length to straight distance, at least 1
 * @param tolerance tolerance of arrival, metres
 * @param batteryReserve charge below which it does not help, 0 to below 1
 * @param southWest of the field, south-west; null for an unlimited field
 * @param northEast corner, north-east; likewise
 */
record RobotTraits(
    List<String> percepts,
    double speed,
    double detourFactor,
    double tolerance,
    double batteryReserve,
    @Nullable GeoPosition southWest,
    @Nullable GeoPosition northEast) {

  static RobotTraits of(Parameters settings) {
    List<String> percepts =
        settings
            .find("percepts")
            .map(text -> List.of(text.strip().split("\\s*,\\s*")))
            .orElse(List.of());
    Optional<String> field = settings.find("field");
    GeoPosition[] corners = field.isPresent() ? corners(settings, field.get()) : null;
    return new RobotTraits(
        percepts.stream().filter(each -> !each.isBlank()).toList(),
        settings.number("speed", 0.5, 0.01, 50),
        settings.number("detour_factor", 1.2, 1, 10),
        settings.number("tolerance", 1, 0.05, 20),
        settings.number("battery_reserve", 0.1, 0, 0.99),
        corners == null ? null : corners[0],
        corners == null ? null : corners[1]);
  }

  private static GeoPosition[] corners(Parameters settings, String text) {
    String expected =
        "two corners, south-west and north-east: latitude,longitude latitude,longitude";
    String[] parts = text.strip().split("[,\\s]+");
    try {
      if (parts.length == 4) {
        GeoPosition southWest =
            new GeoPosition(Double.parseDouble(parts[0]), Double.parseDouble(parts[1]), 0);
        GeoPosition northEast =
            new GeoPosition(Double.parseDouble(parts[2]), Double.parseDouble(parts[3]), 0);
        LocalPosition across = new LocalFrame(southWest).toLocal(northEast);
        if (across.east() > 0 && across.north() > 0) {
          return new GeoPosition[] {southWest, northEast};
        }
      }
    } catch (IllegalArgumentException e) {
      throw settings.fault("field", expected, e);
    }
    throw settings.fault("field", expected, null);
  }

  boolean isInField(GeoPosition place) {
    if (southWest == null || northEast == null) {
      return true;
    }
    LocalFrame frame = new LocalFrame(southWest);
    LocalPosition at = frame.toLocal(place);
    LocalPosition far = frame.toLocal(northEast);
    return at.east() >= 0
        && at.north() >= 0
        && at.east() <= far.east()
        && at.north() <= far.north();
  }

  /** From corner to corner, metres; 141 m, as for a field of 100 m, where it is unlimited. */
  double diagonal() {
    return southWest == null || northEast == null
        ? 100 * Math.sqrt(2)
        : southWest.groundDistance(northEast);
  }
}
