package org.dfra.core.geojson;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dfra.core.config.ConfigurationFaults;
import org.dfra.core.config.SourceLocation;
import org.dfra.geometry.GeoPosition;

/**
 * A GeoJSON feature.
 *
 * @param place its first line
 * @param properties its properties; a missing node if it has none
 * @param geometry its shape; a missing node if it has none
 */
public record GeoJsonFeature(SourceLocation place, JsonNode properties, JsonNode geometry) {

  /** The type of its geometry, such as Polygon; {@code none} if it has none. */
  public String type() {
    return geometry.path("type").asText("none");
  }

  /** The coordinates of its geometry; a missing node if it has none. */
  public JsonNode coordinates() {
    return geometry.path("coordinates");
  }

  /**
   * The corners of a polygon's single ring, as in the file: a repeated first corner is kept.
   * Heights are ignored, and 0. Empty, with a recorded fault, if the polygon has holes, or a corner
   * is not a position.
   */
  public Optional<List<GeoPosition>> ring(ConfigurationFaults faults) {
    if (coordinates().size() != 1) {
      faults.add(
          place,
          "a polygon has "
              + coordinates().size()
              + " rings; write one, since a polygon here has no holes");
      return Optional.empty();
    }
    List<GeoPosition> corners = new ArrayList<>();
    for (JsonNode point : coordinates().path(0)) {
      Optional<GeoPosition> corner = position(point, faults);
      if (corner.isEmpty()) {
        return Optional.empty();
      }
      corners.add(corner.get());
    }
    return Optional.of(corners);
  }

  /**
   * The position of a pair of coordinates, its height ignored, and 0; empty, with a recorded fault,
   * if it is not one.
   */
  public Optional<GeoPosition> position(JsonNode pair, ConfigurationFaults faults) {
    JsonNode longitude = pair.path(0);
    JsonNode latitude = pair.path(1);
    if (!longitude.isNumber()
        || !latitude.isNumber()
        || !(Math.abs(longitude.asDouble()) <= 180)
        || !(Math.abs(latitude.asDouble()) <= 90)) {
      faults.add(
          place,
          pair + " is not a position; write [longitude, latitude] in degrees, longitude first");
      return Optional.empty();
    }
    return Optional.of(new GeoPosition(latitude.asDouble(), longitude.asDouble(), 0));
  }
}
