package org.dfra.sim.world.description;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.ConfigurationFaults;
import org.dfra.core.config.Place;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.world.shape.Polygon;

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
 * @throws ConfigurationException naming all errors of all parts
 */
public record WorldDescription(
    String name,
    long seed,
    GeoPosition datum,
    GroundDescription ground,
    WeatherDescription weather,
    List<ObstacleDescription> obstacles,
    List<MineDescription> mines,
    Optional<Polygon> region,
    List<VehicleDescription> vehicles,
    Place place) {

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
        Place.CODE);
  }

  /** The same world with another seed. */
  public WorldDescription withSeed(long other) {
    return new WorldDescription(
        name, other, datum, ground, weather, obstacles, mines, region, vehicles, place);
  }

  /** The same world with one obstacle more. */
  public WorldDescription with(ObstacleDescription obstacle) {
    return new WorldDescription(
        name,
        seed,
        datum,
        ground,
        weather,
        more(obstacles, obstacle),
        mines,
        region,
        vehicles,
        place);
  }

  /** The same world with one mine more. */
  public WorldDescription with(MineDescription mine) {
    return new WorldDescription(
        name, seed, datum, ground, weather, obstacles, more(mines, mine), region, vehicles, place);
  }

  /** The same world with one robot more. */
  public WorldDescription with(VehicleDescription vehicle) {
    return new WorldDescription(
        name,
        seed,
        datum,
        ground,
        weather,
        obstacles,
        mines,
        region,
        more(vehicles, vehicle),
        place);
  }

  /** The same world on other ground. */
  public WorldDescription withGround(GroundDescription other) {
    return new WorldDescription(
        name, seed, datum, other, weather, obstacles, mines, region, vehicles, place);
  }

  /** The same world in other weather. */
  public WorldDescription withWeather(WeatherDescription other) {
    return new WorldDescription(
        name, seed, datum, ground, other, obstacles, mines, region, vehicles, place);
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
}
