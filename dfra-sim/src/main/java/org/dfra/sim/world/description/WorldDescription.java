package org.dfra.sim.world.description;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.ConfigurationFaults;
import org.dfra.core.config.SourceLocation;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.world.shape.PlanarShape;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.dfra.sim.world.shape.PlanarShape.Polygon;

/**
 * The initial state of a world. Two worlds created from equal descriptions are equal at all times,
 * if the robots get the same commands.
 *
 * @param name of the world, in lower_snake_case
 * @param seed of all random numbers
 * @param datum origin of the world's ENU frame, and the field's south-west corner
 * @param ground the field
 * @param weather sun, temperature, wind
 * @param obstacles on the ground
 * @param mines on the ground
 * @param region of the field that a mission covers, if one is given
 * @param vehicles the robots, in the order in which their motion is computed
 * @param place its source location
 */
public record WorldDescription(
    String name,
    long seed,
    GeoPosition datum,
    WorldDescription.GroundDescription ground,
    WorldDescription.WeatherDescription weather,
    List<WorldDescription.ObstacleDescription> obstacles,
    List<WorldDescription.MineDescription> mines,
    Optional<Polygon> region,
    List<VehicleDescription> vehicles,
    SourceLocation place) {

  /**
   * Checks all parts.
   *
   * @throws ConfigurationException naming all errors of all parts
   */
  public WorldDescription {
    obstacles = List.copyOf(obstacles);
    mines = List.copyOf(mines);
    vehicles = List.copyOf(vehicles);
    ConfigurationFaults faults = new ConfigurationFaults();
    WorldRules.check(name, datum, ground, weather, place, faults);
    WorldRules.check(obstacles, mines, vehicles, faults);
    faults.throwIfAny();
  }

  /** An empty field in fair weather, for tests and examples. */
  public WorldDescription(String name, long seed, GeoPosition datum, double width, double depth) {
    this(
        name,
        seed,
        datum,
        new GroundDescription(width, depth),
        WeatherDescription.FAIR,
        List.of(),
        List.of(),
        Optional.empty(),
        List.of(),
        SourceLocation.CODE);
  }

  /** The same world with another seed. */
  public WorldDescription withSeed(long other) {
    return copy(other, ground, weather, obstacles, mines, vehicles);
  }

  /** The same world with one obstacle more. */
  public WorldDescription with(ObstacleDescription obstacle) {
    return copy(seed, ground, weather, more(obstacles, obstacle), mines, vehicles);
  }

  /** The same world with one mine more. */
  public WorldDescription with(MineDescription mine) {
    return copy(seed, ground, weather, obstacles, more(mines, mine), vehicles);
  }

  /** The same world with one robot more. */
  public WorldDescription with(VehicleDescription vehicle) {
    return copy(seed, ground, weather, obstacles, mines, more(vehicles, vehicle));
  }

  /** The same world with these obstacles and robots only. */
  public WorldDescription with(
      List<ObstacleDescription> otherObstacles, List<VehicleDescription> otherVehicles) {
    return copy(seed, ground, weather, otherObstacles, mines, otherVehicles);
  }

  /** The same world on other ground. */
  public WorldDescription withGround(GroundDescription other) {
    return copy(seed, other, weather, obstacles, mines, vehicles);
  }

  /** The same world in other weather. */
  public WorldDescription withWeather(WeatherDescription other) {
    return copy(seed, ground, other, obstacles, mines, vehicles);
  }

  private WorldDescription copy(
      long random,
      GroundDescription on,
      WeatherDescription in,
      List<ObstacleDescription> around,
      List<MineDescription> under,
      List<VehicleDescription> robots) {
    return new WorldDescription(name, random, datum, on, in, around, under, region, robots, place);
  }

  /**
   * The robot of that name.
   *
   * @throws ConfigurationException if there is none
   */
  public VehicleDescription vehicle(String robot) {
    return vehicles.stream()
        .filter(one -> one.name().equals(robot))
        .findFirst()
        .orElseThrow(
            () ->
                new ConfigurationException(
                    place + ": the world " + name + " has no robot " + robot + "; add one"));
  }

  private static <T> List<T> more(List<T> some, T one) {
    List<T> more = new ArrayList<>(some);
    more.add(one);
    return more;
  }

  /**
   * The ground: a plane. The field is its part from the datum to the given distances east and
   * north; robots can leave it.
   *
   * @param sizeEast of the field, east of the datum, metres, above 0 to 100 km
   * @param sizeNorth of the field, north of the datum, metres, above 0 to 100 km
   * @param roughness σ of the slope that tilts a robot's body, radians, 0 to 0.2; 0 is a plane
   * @param place its source location
   */
  public record GroundDescription(
      double sizeEast, double sizeNorth, double roughness, SourceLocation place) {

    /** Even ground. */
    public GroundDescription(double width, double depth) {
      this(width, depth, 0, SourceLocation.CODE);
    }
  }

  /**
   * Sun, temperature and wind; they do not change.
   *
   * @param temperature of the air, kelvin, 200 to 350
   * @param groundWarming temperature of bare ground in the sun minus that of the air, kelvin, −30
   *     to 60; at night it is negative
   * @param sunAzimuth direction of the sun, radians from east, counter-clockwise is +
   * @param sunElevation above the horizon, radians, −π/2 to π/2; below 0 is night
   * @param windSpeed speed, metres per second, 0 to 50
   * @param windTowards direction to which it blows, radians from east, counter-clockwise is +
   * @param gustSigma σ of the wind's velocity changes, east and north each, metres per second, 0 to
   *     50
   * @param place its source location
   */
  public record WeatherDescription(
      double temperature,
      double groundWarming,
      double sunAzimuth,
      double sunElevation,
      double windSpeed,
      double windTowards,
      double gustSigma,
      SourceLocation place) {

    /** A sunny afternoon with a breeze. */
    public static final WeatherDescription FAIR =
        new WeatherDescription(293.15, 10, -2.4, 0.8, 2, 0, 0.8, SourceLocation.CODE);
  }

  /**
   * A mine that lies on the ground. Visible to cameras, below the beams of lasers.
   *
   * @param name unique in its world, in lower_snake_case
   * @param east of its centre, metres
   * @param north of its centre, metres
   * @param radius metres, above 0
   * @param height metres, above 0
   * @param thermalContrast temperature minus that of the ground around it, kelvin; colder is
   *     negative
   * @param colour 0xRRGGBB
   * @param place its source location
   */
  public record MineDescription(
      String name,
      double east,
      double north,
      double radius,
      double height,
      double thermalContrast,
      int colour,
      SourceLocation place) {

    /** Of a mine against vehicles, metres. */
    public static final double RADIUS = 0.16;

    /** Of a mine against vehicles, metres. */
    public static final double HEIGHT = 0.1;

    /** In the afternoon of a sunny day, kelvin. */
    public static final double CONTRAST = 4;

    /** Olive. */
    public static final int COLOUR = 0x3F4526;

    /** Created in code, of the default size. */
    public MineDescription(String name, double east, double north) {
      this(name, east, north, RADIUS, HEIGHT, CONTRAST, COLOUR, SourceLocation.CODE);
    }
  }

  /**
   * An obstacle: a post, a hedge, a house.
   *
   * @param name unique in its world, in lower_snake_case
   * @param footprint seen from above, metres east and north of the datum
   * @param height metres, above 0
   * @param reflectivity part of a laser's light that it returns, 0 to 1; 0 is invisible
   * @param colour 0xRRGGBB
   * @param place its source location
   */
  public record ObstacleDescription(
      String name,
      PlanarShape footprint,
      double height,
      double reflectivity,
      int colour,
      SourceLocation place) {

    /** Default reflectivity. */
    public static final double REFLECTIVITY = 0.4;

    /** Created in code, with default reflectivity and colour. */
    public ObstacleDescription(String name, PlanarShape outline, double height) {
      this(name, outline, height, REFLECTIVITY, colour(outline), SourceLocation.CODE);
    }

    /** Default colour: a post as weathered wood, others as a hedge. */
    public static int colour(PlanarShape outline) {
      return outline instanceof Disc ? 0x9A8F7D : 0x35562A;
    }
  }
}
