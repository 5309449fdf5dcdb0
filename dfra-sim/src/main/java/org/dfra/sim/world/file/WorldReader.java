package org.dfra.sim.world.file;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dfra.core.config.ConfigurationFaults;
import org.dfra.core.config.SourceLocation;
import org.dfra.core.config.Substitution;
import org.dfra.core.config.XmlValues;
import org.dfra.core.geojson.GeoJsonFeature;
import org.dfra.core.geojson.GeoJsonFile;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.description.WorldDescription.GroundDescription;
import org.dfra.sim.world.description.WorldDescription.MineDescription;
import org.dfra.sim.world.description.WorldDescription.ObstacleDescription;
import org.dfra.sim.world.description.WorldDescription.WeatherDescription;
import org.dfra.sim.world.description.WorldRules;
import org.dfra.sim.world.shape.PlanarShape;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.jdom2.Element;

/**
 * One reading of one world's XML. The schema finds its own errors; this class or {@link WorldRules}
 * records all others, and reading continues, so that all errors are reported together.
 */
final class WorldReader {

  private final Path file;
  private final ConfigurationFaults faults;
  private final XmlValues values;
  private final XmlNumberParser numbers;
  private final XmlValues.UniqueNames singles;
  private final WorldObjectCollector things = new WorldObjectCollector();

  WorldReader(Path file, Substitution substitution, ConfigurationFaults faults) {
    this.file = file;
    this.faults = faults;
    this.values = new XmlValues(file.toString(), substitution, faults);
    this.numbers = new XmlNumberParser(values);
    this.singles = values.uniqueNames();
  }

  /** The world; empty, with the reasons among the faults, if it is invalid. */
  Optional<WorldDescription> world(Element root) {
    String name = values.attribute(root, "name", "");
    long seed = numbers.seed(root);
    GeoPosition datum = datum(root);
    GroundDescription ground = ground(root);
    WeatherDescription weather = weather(root);
    things(root, new LocalFrame(datum));
    List<VehicleDescription> robots = robots(root);
    SourceLocation whole = values.place(root);
    WorldRules.check(name == null ? "" : name, datum, ground, weather, whole, faults);
    WorldRules.check(things.obstacles(), things.mines(), robots, faults);
    return faults.isEmpty() && name != null
        ? Optional.of(
            new WorldDescription(
                name,
                seed,
                datum,
                ground,
                weather,
                things.obstacles(),
                things.mines(),
                things.region(),
                robots,
                whole))
        : Optional.empty();
  }

  private GeoPosition datum(Element root) {
    GeoPosition datum = new GeoPosition(0, 0, 0);
    for (Element element : required(root, "datum")) {
      double latitude = numbers.number(element, "latitude", 0);
      double longitude = numbers.number(element, "longitude", 0);
      try {
        datum = new GeoPosition(latitude, longitude, numbers.number(element, "height", 0));
      } catch (IllegalArgumentException e) {
        values.check(element, e.getMessage() + "; write degrees");
      }
    }
    return datum;
  }

  private GroundDescription ground(Element root) {
    GroundDescription ground = new GroundDescription(1, 1);
    for (Element element : required(root, "ground")) {
      ground =
          new GroundDescription(
              numbers.number(element, "size_east", 1),
              numbers.number(element, "size_north", 1),
              numbers.number(element, "roughness", 0),
              values.place(element));
    }
    return ground;
  }

  /** The only element of that name; a fault where it is missing. */
  private List<Element> required(Element root, String name) {
    List<Element> found = single(root, name);
    if (found.isEmpty()) {
      values.check(root, "the world has no <" + name + ">; add one");
    }
    return found;
  }

  private List<Element> single(Element root, String name) {
    List<Element> found = children(root, name);
    found.forEach(
        element -> singles.requireFirst(element, name, "<" + name + ">", "make them one"));
    return found;
  }

  private WeatherDescription weather(Element root) {
    WeatherDescription fair = WeatherDescription.FAIR;
    WeatherDescription weather = fair;
    for (Element element : single(root, "weather")) {
      weather =
          new WeatherDescription(
              numbers.number(element, "temperature", fair.temperature()),
              numbers.number(element, "ground_warming", fair.groundWarming()),
              numbers.number(element, "sun_azimuth", fair.sunAzimuth()),
              numbers.number(element, "sun_elevation", fair.sunElevation()),
              numbers.number(element, "wind_speed", fair.windSpeed()),
              numbers.number(element, "wind_towards", fair.windTowards()),
              numbers.number(element, "gust_sigma", fair.gustSigma()),
              values.place(element));
    }
    return weather;
  }

  /** The objects of the world, in document order. */
  private void things(Element root, LocalFrame frame) {
    for (Element element : root.getChildren()) {
      switch (element.getName()) {
        case "post" -> post(element);
        case "obstacle" -> obstacle(element);
        case "mine" -> mine(element);
        case "features" -> features(element, frame);
        case "region" ->
            numbers
                .polygon(element)
                .ifPresent(p -> things.region(p, values.place(element), faults));
        default -> {
          // the schema permits others, which are read elsewhere
        }
      }
    }
  }

  private void post(Element element) {
    double radius = numbers.number(element, "radius", WorldObjectCollector.POST_RADIUS);
    if (!(radius > 0)) {
      values.check(element, "radius is " + radius + " m; write a number above 0");
      return;
    }
    double east = numbers.number(element, "east", 0);
    double north = numbers.number(element, "north", 0);
    String name = things.name("post", values.attribute(element, "name"));
    things.add(obstacle(element, name, new Disc(east, north, radius)));
  }

  private void obstacle(Element element) {
    String name = things.name("obstacle", values.attribute(element, "name"));
    numbers.polygon(element).ifPresent(outline -> things.add(obstacle(element, name, outline)));
  }

  private ObstacleDescription obstacle(Element element, String name, PlanarShape outline) {
    return new ObstacleDescription(
        name,
        outline,
        numbers.number(element, "height", WorldObjectCollector.HEIGHT),
        numbers.number(element, "reflectivity", ObstacleDescription.REFLECTIVITY),
        numbers.colour(element, ObstacleDescription.colour(outline)),
        values.place(element));
  }

  private void mine(Element element) {
    things.add(
        new MineDescription(
            things.name("mine", values.attribute(element, "name")),
            numbers.number(element, "east", 0),
            numbers.number(element, "north", 0),
            numbers.number(element, "radius", MineDescription.RADIUS),
            numbers.number(element, "height", MineDescription.HEIGHT),
            numbers.number(element, "thermal_contrast", MineDescription.CONTRAST),
            numbers.colour(element, MineDescription.COLOUR),
            values.place(element)));
  }

  private void features(Element element, LocalFrame frame) {
    String href = values.attribute(element, "href");
    if (href == null) {
      return;
    }
    try {
      Path path = file.resolveSibling(href).normalize();
      if (Files.isRegularFile(path)) {
        new GeoJsonReader(path, frame, things, faults).read();
        return;
      }
    } catch (InvalidPathException e) {
      // an invalid path is a missing file, too
    }
    values.check(
        element, "the file \"" + href + "\" does not exist; name one, relative to " + file);
  }

  private List<VehicleDescription> robots(Element root) {
    RobotElements reader = new RobotElements(values, numbers);
    children(root, "defaults").forEach(reader::defaults);
    List<VehicleDescription> robots = new ArrayList<>();
    children(root, "robot").forEach(element -> reader.robot(element).ifPresent(robots::add));
    return robots;
  }

  private static List<Element> children(Element element, String name) {
    return element.getChildren(name, WorldXml.SCHEMA.namespace());
  }

  /**
   * One reading of one GeoJSON file: a FeatureCollection whose polygons are obstacles or the
   * region, whose points are posts or mines, by the property {@code kind}. Errors are recorded with
   * the line in which the feature begins.
   */
  private static final class GeoJsonReader {

    private final Path file;
    private final LocalFrame frame;
    private final WorldObjectCollector things;
    private final ConfigurationFaults faults;

    GeoJsonReader(
        Path file, LocalFrame frame, WorldObjectCollector things, ConfigurationFaults faults) {
      this.file = file;
      this.frame = frame;
      this.things = things;
      this.faults = faults;
    }

    void read() {
      GeoJsonFile read = GeoJsonFile.read(file, faults);
      if (!read.isCollection() && !read.isBroken()) {
        faults.add(
            read.place(),
            "its type is "
                + read.type()
                + "; write a FeatureCollection with an array of features, {\"type\":"
                + " \"FeatureCollection\", \"features\": […]}");
        return;
      }
      for (GeoJsonFeature feature : read.features()) {
        new GeoFeature(feature, frame, things, faults).read();
      }
    }
  }
}
