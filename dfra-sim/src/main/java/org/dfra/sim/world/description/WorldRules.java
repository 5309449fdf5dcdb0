package org.dfra.sim.world.description;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.dfra.core.config.ConfigurationFaults;
import org.dfra.core.config.DescriptionRules;
import org.dfra.core.config.SourceLocation;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.world.description.WorldDescription.GroundDescription;
import org.dfra.sim.world.description.WorldDescription.MineDescription;
import org.dfra.sim.world.description.WorldDescription.ObstacleDescription;
import org.dfra.sim.world.description.WorldDescription.WeatherDescription;
import org.dfra.sim.world.shape.OrientedRectangle;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.dfra.sim.world.shape.StaticObstacle;
import org.jspecify.annotations.Nullable;

/** Validates a world: records all errors with their source locations. */
public final class WorldRules {

  /** Maximum distance from the datum, metres. */
  private static final double FARTHEST = 10_000;

  private static final double LARGEST_FIELD = 100_000; // metres
  private static final double ROUGHEST = 0.2; // radians
  private static final double TALLEST = 1000; // metres
  private static final double LAST_LATITUDE = 89; // degrees: nearer to a pole, east is ill-defined

  private WorldRules() {}

  /** Records errors of a world as a whole. */
  public static void check(
      String name,
      GeoPosition datum,
      GroundDescription ground,
      WeatherDescription weather,
      SourceLocation place,
      ConfigurationFaults faults) {
    FaultCollector notes = new FaultCollector(place, "", faults);
    notes.add(DescriptionRules.name("world", name));
    notes.between("latitude of the datum", "°", datum.latitude(), -LAST_LATITUDE, LAST_LATITUDE);
    FaultCollector field = new FaultCollector(ground.place(), "the ground's ", faults);
    field.positive("size_east", ground.sizeEast(), LARGEST_FIELD);
    field.positive("size_north", ground.sizeNorth(), LARGEST_FIELD);
    field.between("roughness", "rad", ground.roughness(), 0, ROUGHEST);
    FaultCollector sky = new FaultCollector(weather.place(), "the weather's ", faults);
    sky.between("temperature", "K", weather.temperature(), 200, 350);
    sky.between("ground_warming", "K", weather.groundWarming(), -30, 60);
    sky.between("sun_azimuth", "rad", weather.sunAzimuth(), -10, 10);
    sky.between("sun_elevation", "rad", weather.sunElevation(), -Math.PI / 2, Math.PI / 2);
    sky.between("wind_speed", "m/s", weather.windSpeed(), 0, 50);
    sky.between("wind_towards", "rad", weather.windTowards(), -10, 10);
    sky.between("gust_sigma", "m/s", weather.gustSigma(), 0, 50);
  }

  /** Records errors of a world's objects, of each alone and between them. */
  public static void check(
      List<ObstacleDescription> obstacles,
      List<MineDescription> mines,
      List<VehicleDescription> vehicles,
      ConfigurationFaults faults) {
    Set<String> names = new HashSet<>();
    for (ObstacleDescription obstacle : obstacles) {
      Disc bounds = obstacle.footprint().bounds();
      FaultCollector notes =
          thing(
              "obstacle",
              obstacle.name(),
              bounds.east(),
              bounds.north(),
              obstacle.place(),
              names,
              faults);
      notes.positive("height", obstacle.height(), TALLEST);
      notes.between("reflectivity", "", obstacle.reflectivity(), 0, 1);
      notes.between("colour", "", obstacle.colour(), 0, 0xFFFFFF);
    }
    for (MineDescription mine : mines) {
      FaultCollector notes =
          thing("mine", mine.name(), mine.east(), mine.north(), mine.place(), names, faults);
      notes.positive("radius", mine.radius(), 10);
      notes.positive("height", mine.height(), 10);
      notes.between("thermal_contrast", "K", mine.thermalContrast(), -100, 100);
      notes.between("colour", "", mine.colour(), 0, 0xFFFFFF);
    }
    for (VehicleDescription robot : vehicles) {
      FaultCollector notes =
          thing("robot", robot.name(), robot.east(), robot.north(), robot.place(), names, faults);
      notes.between("yaw", "rad", robot.yaw(), -10, 10);
      notes.positive("length", robot.length(), 100);
      notes.positive("width", robot.width(), 100);
      notes.positive("height", robot.height(), 100);
      DeviceRules.check(robot, faults);
    }
    starts(obstacles, vehicles, faults);
  }

  private static FaultCollector thing(
      String what,
      String name,
      double east,
      double north,
      SourceLocation place,
      Set<String> names,
      ConfigurationFaults faults) {
    FaultCollector notes = new FaultCollector(place, name + "'s ", faults);
    notes.add(DescriptionRules.name(what, name));
    if (!names.add(name)) {
      faults.add(
          place,
          "there is a second "
              + name
              + " among the obstacles, mines and robots; rename or delete one");
    }
    double distance = Math.sqrt(east * east + north * north);
    if (!Double.isFinite(distance)) {
      notes.add(name + " is at east " + east + ", north " + north + "; write finite numbers");
    } else if (distance > FARTHEST) {
      notes.add(
          name
              + " is "
              + Math.round(distance / 1000)
              + " km from the datum, farther than "
              + Math.round(FARTHEST / 1000)
              + " km; correct it or the datum, and see that latitude and longitude are not"
              + " swapped");
    }
    return notes;
  }

  /** Records robots that start inside an obstacle, if all initial poses are valid. */
  private static void starts(
      List<ObstacleDescription> obstacles,
      List<VehicleDescription> vehicles,
      ConfigurationFaults faults) {
    List<StaticObstacle> solids =
        obstacles.stream()
            .map(o -> new StaticObstacle(o.name(), o.footprint(), o.height(), 1))
            .toList();
    List<VehicleDescription> placed = new ArrayList<>();
    for (VehicleDescription robot : vehicles) {
      OrientedRectangle box = box(robot);
      Stream.concat(
              solids.stream().filter(box::touches).map(StaticObstacle::name),
              placed.stream().filter(o -> box(o).touches(box)).map(VehicleDescription::name))
          .findFirst()
          .ifPresent(
              other ->
                  faults.add(
                      robot.place(),
                      robot.name() + " starts at the position of " + other + "; move one of them"));
      placed.add(robot);
    }
  }

  /** The rectangle of a robot at its start. */
  private static OrientedRectangle box(VehicleDescription robot) {
    OrientedRectangle box = new OrientedRectangle(robot.length(), robot.width());
    box.move(robot.east(), robot.north(), StrictMath.cos(robot.yaw()), StrictMath.sin(robot.yaw()));
    return box;
  }

  /** Records errors of the numbers of one object. */
  private record FaultCollector(SourceLocation place, String of, ConfigurationFaults faults) {

    void add(@Nullable String complaint) {
      if (complaint != null) {
        faults.add(place, complaint);
      }
    }

    void positive(String what, double metres, double most) {
      if (!(metres > 0 && metres <= most)) {
        add(of + what + " is " + metres + " m; write a number above 0, up to " + most + " m");
      }
    }

    void between(String what, String unit, double value, double lowest, double highest) {
      if (!(value >= lowest && value <= highest)) {
        String in = unit.isEmpty() ? "" : " " + unit;
        add(
            (of + what + " is " + value + in)
                + ("; write a number from " + lowest + " to " + highest + in));
      }
    }
  }
}
