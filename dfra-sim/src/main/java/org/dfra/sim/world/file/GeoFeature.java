package org.dfra.sim.world.file;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dfra.core.config.ConfigurationFaults;
import org.dfra.core.config.NearestName;
import org.dfra.core.config.RenamedNames;
import org.dfra.core.config.SourceLocation;
import org.dfra.core.geojson.GeoJsonFeature;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.sim.world.description.WorldDescription.MineDescription;
import org.dfra.sim.world.description.WorldDescription.ObstacleDescription;
import org.dfra.sim.world.shape.PlanarShape;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.dfra.sim.world.shape.PlanarShape.Vertex;
import org.jspecify.annotations.Nullable;

/** One feature of GeoJSON: an object in a world, if it is valid. */
final class GeoFeature {

  private static final List<String> OF_POINT = List.of("post", "mine");
  private static final List<String> OF_POLYGON = List.of("obstacle", "region");

  private final GeoJsonFeature feature;
  private final JsonNode properties;
  private final SourceLocation place;
  private final LocalFrame frame;
  private final WorldObjectCollector things;
  private final ConfigurationFaults faults;

  GeoFeature(
      GeoJsonFeature feature,
      LocalFrame frame,
      WorldObjectCollector things,
      ConfigurationFaults faults) {
    this.feature = feature;
    this.properties = feature.properties();
    this.place = feature.place();
    this.frame = frame;
    this.things = things;
    this.faults = faults;
  }

  void read() {
    switch (feature.type()) {
      case "Point" -> kind(OF_POINT, null).ifPresent(this::point);
      case "Polygon" -> kind(OF_POLYGON, "obstacle").ifPresent(this::polygon);
      default ->
          faults.add(
              place,
              "the geometry of a feature is "
                  + feature.type()
                  + ", which a world does not use; write a Point for a post or a mine, a Polygon"
                  + " for an obstacle or the region");
    }
  }

  private Optional<String> kind(List<String> known, @Nullable String absent) {
    JsonNode written = properties.path("kind");
    if (written.isMissingNode() && absent != null) {
      return Optional.of(absent);
    }
    if (written.isTextual() && known.contains(written.asText())) {
      return Optional.of(written.asText());
    }
    String otherwise = "; write " + String.join(" or ", known) + " in its properties";
    faults.add(
        place,
        "the kind of a "
            + feature.type().toLowerCase(Locale.ROOT)
            + (written.isMissingNode()
                ? " is missing" + otherwise
                : " is "
                    + written.asText()
                    + NearestName.hint(written.asText(), known, otherwise)));
    return Optional.empty();
  }

  private void point(String kind) {
    String name = name(kind);
    Optional<Vertex> at = feature.position(feature.coordinates(), faults).map(this::vertex);
    boolean isPost = kind.equals("post");
    double radius =
        number("radius", isPost ? WorldObjectCollector.POST_RADIUS : MineDescription.RADIUS);
    if (at.isEmpty()) {
      return;
    }
    double east = at.get().east();
    double north = at.get().north();
    if (!isPost) {
      things.add(
          new MineDescription(
              name,
              east,
              north,
              radius,
              number("height", MineDescription.HEIGHT),
              number(key("mine", "thermal_contrast"), MineDescription.CONTRAST),
              colour(MineDescription.COLOUR),
              place));
    } else if (radius > 0) {
      things.add(obstacle(name, new Disc(east, north, radius)));
    } else {
      faults.add(place, "radius is " + radius + " m; write a number above 0");
    }
  }

  private void polygon(String kind) {
    Optional<List<GeoPosition>> ring = feature.ring(faults);
    if (ring.isEmpty()) {
      return;
    }
    List<Vertex> corners = ring.get().stream().map(this::vertex).toList();
    try {
      Polygon outline = new Polygon(corners);
      if (kind.equals("region")) {
        things.region(outline, place, faults);
      } else {
        things.add(obstacle(name(kind), outline));
      }
    } catch (IllegalArgumentException e) {
      faults.add(place, String.valueOf(e.getMessage()));
    }
  }

  private ObstacleDescription obstacle(String name, PlanarShape outline) {
    return new ObstacleDescription(
        name,
        outline,
        number("height", WorldObjectCollector.HEIGHT),
        number("reflectivity", ObstacleDescription.REFLECTIVITY),
        colour(ObstacleDescription.colour(outline)),
        place);
  }

  private String name(String kind) {
    JsonNode written = properties.path("name");
    return things.name(kind, written.isMissingNode() ? null : written.asText());
  }

  /** The key of a property: its name, or its old name where that is written. */
  private String key(String element, String name) {
    String scope = RenamedNames.attributesOf(element);
    String key = name;
    for (Iterator<String> each = properties.fieldNames(); each.hasNext(); ) {
      String written = each.next();
      if (!written.equals(name)
          && RenamedNames.resolve(scope, place, "the property", written).equals(name)) {
        key = written;
      }
    }
    if (!key.equals(name) && properties.has(name)) {
      faults.add(place, name + " and its old name " + key + " are both given; delete " + key);
    }
    return key;
  }

  private double number(String name, double absent) {
    JsonNode written = properties.path(name);
    if (!written.isMissingNode() && !written.isNumber()) {
      faults.add(place, name + " is " + written + "; write a number, without quotes");
    }
    return written.isNumber() ? written.asDouble() : absent;
  }

  private int colour(int absent) {
    JsonNode written = properties.path("colour");
    if (written.isMissingNode()) {
      return absent;
    }
    Optional<Integer> colour = XmlNumberParser.colour(written.asText());
    if (colour.isEmpty()) {
      faults.add(place, XmlNumberParser.colourComplaint(written.asText()));
    }
    return colour.orElse(absent);
  }

  /** The point east and north of the datum; heights in GeoJSON are ignored. */
  private Vertex vertex(GeoPosition position) {
    LocalPosition at =
        frame.toLocal(
            new GeoPosition(position.latitude(), position.longitude(), frame.datum().height()));
    return new Vertex(at.east(), at.north());
  }
}
