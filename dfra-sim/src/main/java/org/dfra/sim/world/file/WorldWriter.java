package org.dfra.sim.world.file;

import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.dfra.core.config.Substitution;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceDescription.MountPose;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.description.WorldDescription.GroundDescription;
import org.dfra.sim.world.description.WorldDescription.MineDescription;
import org.dfra.sim.world.description.WorldDescription.ObstacleDescription;
import org.dfra.sim.world.description.WorldDescription.WeatherDescription;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.jdom2.Document;
import org.jdom2.Element;
import org.jdom2.output.Format;
import org.jdom2.output.LineSeparator;
import org.jdom2.output.XMLOutputter;

/** Writes a world as XML without unresolved references. */
final class WorldWriter {

  private WorldWriter() {}

  static String text(WorldDescription world) {
    Element root = element("world");
    set(root, "name", world.name());
    set(root, "seed", Long.toString(world.seed()));
    root.addContent(datum(world.datum()));
    root.addContent(ground(world.ground()));
    root.addContent(weather(world.weather()));
    world.obstacles().forEach(obstacle -> root.addContent(obstacle(obstacle)));
    world.mines().forEach(mine -> root.addContent(mine(mine)));
    world
        .region()
        .ifPresent(
            region -> {
              Element element = element("region");
              set(element, "points", points(region));
              root.addContent(element);
            });
    world.vehicles().forEach(robot -> root.addContent(robot(robot)));
    Format format = Format.getPrettyFormat().setLineSeparator(LineSeparator.UNIX);
    return new XMLOutputter(format).outputString(new Document(root));
  }

  private static Element datum(GeoPosition datum) {
    Element element = element("datum");
    set(element, "latitude", datum.latitude());
    set(element, "longitude", datum.longitude());
    set(element, "height", datum.height());
    return element;
  }

  private static Element ground(GroundDescription ground) {
    Element element = element("ground");
    set(element, "size_east", ground.sizeEast());
    set(element, "size_north", ground.sizeNorth());
    set(element, "roughness", ground.roughness());
    return element;
  }

  private static Element weather(WeatherDescription weather) {
    Element element = element("weather");
    set(element, "temperature", weather.temperature());
    set(element, "ground_warming", weather.groundWarming());
    set(element, "sun_azimuth", weather.sunAzimuth());
    set(element, "sun_elevation", weather.sunElevation());
    set(element, "wind_speed", weather.windSpeed());
    set(element, "wind_towards", weather.windTowards());
    set(element, "gust_sigma", weather.gustSigma());
    return element;
  }

  private static Element obstacle(ObstacleDescription obstacle) {
    Element element;
    if (obstacle.footprint() instanceof Disc disc) {
      element = element("post");
      set(element, "name", obstacle.name());
      set(element, "east", disc.east());
      set(element, "north", disc.north());
      set(element, "radius", disc.radius());
    } else {
      element = element("obstacle");
      set(element, "name", obstacle.name());
      set(element, "points", points((Polygon) obstacle.footprint()));
    }
    set(element, "height", obstacle.height());
    set(element, "reflectivity", obstacle.reflectivity());
    set(element, "colour", colour(obstacle.colour()));
    return element;
  }

  private static Element mine(MineDescription mine) {
    Element element = element("mine");
    set(element, "name", mine.name());
    set(element, "east", mine.east());
    set(element, "north", mine.north());
    set(element, "radius", mine.radius());
    set(element, "height", mine.height());
    set(element, "thermal_contrast", mine.thermalContrast());
    set(element, "colour", colour(mine.colour()));
    return element;
  }

  private static Element robot(VehicleDescription robot) {
    Element element = element("robot");
    set(element, "name", robot.name());
    set(element, "type", robot.type().text());
    set(element, "east", robot.east());
    set(element, "north", robot.north());
    set(element, "yaw", robot.yaw());
    set(element, "length", robot.length());
    set(element, "width", robot.width());
    set(element, "height", robot.height());
    robot.devices().forEach(device -> element.addContent(device(device)));
    return element;
  }

  private static Element device(DeviceDescription device) {
    Element element = element("device");
    set(element, "kind", device.kind().text());
    set(element, "name", device.name());
    MountPose mount = device.mount();
    set(element, "x", mount.x());
    set(element, "y", mount.y());
    set(element, "z", mount.z());
    set(element, "roll", mount.roll());
    set(element, "pitch", mount.pitch());
    set(element, "yaw", mount.yaw());
    set(element, "parent", device.parent());
    set(element, "protocol", device.emulator().protocol());
    set(element, "link", device.emulator().link());
    set(element, "port", device.emulator().port());
    set(element, "baud", device.emulator().baud());
    new TreeMap<>(device.parameters())
        .forEach(
            (name, value) -> {
              Element parameter = element("parameter");
              set(parameter, "name", name);
              set(parameter, "value", value);
              element.addContent(parameter);
            });
    return element;
  }

  private static String colour(int colour) {
    return String.format("#%06X", colour);
  }

  private static String points(Polygon polygon) {
    return polygon.corners().stream()
        .map(corner -> corner.east() + "," + corner.north())
        .collect(Collectors.joining(" "));
  }

  private static Element element(String name) {
    return new Element(name, WorldXml.SCHEMA.namespace());
  }

  private static void set(Element element, String name, double value) {
    set(element, name, Double.toString(value));
  }

  private static void set(Element element, String name, Optional<String> value) {
    value.ifPresent(text -> set(element, name, text));
  }

  private static void set(Element element, String name, String value) {
    element.setAttribute(name, Substitution.escape(value));
  }
}
