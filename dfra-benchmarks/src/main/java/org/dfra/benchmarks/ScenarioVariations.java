package org.dfra.benchmarks;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.Function;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotDescription.GroupDescription;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.description.WorldDescription.ObstacleDescription;
import org.dfra.sim.world.shape.PlanarShape.Disc;

/** Varies the worlds and robots of description files. */
final class ScenarioVariations {

  private static final double POST_RADIUS = 0.08; // metres
  private static final double POST_DISTANCE = 3; // metres between two
  private static final double START_DISTANCE = 3; // metres from a robot's start

  private ScenarioVariations() {}

  /** The same world with these robots and obstacles. */
  public static WorldDescription world(
      WorldDescription world,
      List<ObstacleDescription> obstacles,
      List<VehicleDescription> vehicles) {
    return world.with(obstacles, vehicles);
  }

  /** The same robot with a random pose nearby: within these metres and radians. */
  public static VehicleDescription withRandomPose(
      VehicleDescription robot, double metres, double radians, Random random) {
    return robot.withPose(
        robot.east() + metres * (2 * random.nextDouble() - 1),
        robot.north() + metres * (2 * random.nextDouble() - 1),
        robot.yaw() + radians * (2 * random.nextDouble() - 1));
  }

  /** The same robot with a changed number in all its devices of a kind. */
  public static VehicleDescription withDeviceParameter(
      VehicleDescription robot, DeviceKind kind, String parameter, double value) {
    List<DeviceDescription> devices = new ArrayList<>();
    for (DeviceDescription each : robot.devices()) {
      devices.add(each.kind() == kind ? each.with(parameter, value) : each);
    }
    return robot.withDevices(devices);
  }

  /**
   * This number of posts at random positions in the world's region, apart from each other and from
   * the robots.
   */
  public static List<ObstacleDescription> posts(
      int count, WorldDescription world, List<VehicleDescription> robots, Random random) {
    Disc bounds =
        world
            .region()
            .orElseThrow(() -> new IllegalArgumentException(world.name() + " has no region"))
            .bounds();
    List<double[]> places = new ArrayList<>();
    while (places.size() < count) {
      double east = bounds.east() + bounds.radius() * (2 * random.nextDouble() - 1);
      double north = bounds.north() + bounds.radius() * (2 * random.nextDouble() - 1);
      boolean separation =
          places.stream().allMatch(p -> Math.hypot(p[0] - east, p[1] - north) > POST_DISTANCE)
              && robots.stream()
                  .allMatch(r -> Math.hypot(r.east() - east, r.north() - north) > START_DISTANCE);
      if (separation && world.region().get().contains(east, north)) {
        places.add(new double[] {east, north});
      }
    }
    List<ObstacleDescription> posts = new ArrayList<>();
    for (double[] each : places) {
      posts.add(
          new ObstacleDescription(
              "post_" + (posts.size() + 1), new Disc(each[0], each[1], POST_RADIUS), 1.5));
    }
    return posts;
  }

  /** The same robot with another driver, without parameters, for one of its modules. */
  public static RobotDescription withDriver(RobotDescription robot, String module, String driver) {
    return changed(
        robot, each -> List.of(each.name().equals(module) ? each.withBareDriver(driver) : each));
  }

  /** The same robot with one parameter of one of its modules changed. */
  public static RobotDescription withParameter(
      RobotDescription robot, String module, String parameter, String value) {
    return changed(
        robot,
        each ->
            List.of(
                each.name().equals(module)
                    ? each.withParameter(parameter, value, each.place())
                    : each));
  }

  /** The same robot with additional copies of a module, each with one parameter changed. */
  public static RobotDescription withVariants(
      RobotDescription robot, String module, String parameter, List<String> values) {
    return changed(
        robot,
        each -> {
          List<ModuleDescription> all = new ArrayList<>(List.of(each));
          if (each.name().equals(module)) {
            for (String value : values) {
              all.add(
                  each.withName(module + "_" + value)
                      .withParameter(parameter, value, each.place()));
            }
          }
          return all;
        });
  }

  private static RobotDescription changed(
      RobotDescription robot, Function<ModuleDescription, List<ModuleDescription>> change) {
    List<GroupDescription> groups = new ArrayList<>();
    for (GroupDescription group : robot.groups()) {
      groups.add(
          new GroupDescription(
              group.name(),
              group.jvmOptions(),
              group.registrar(),
              group.modules().stream().flatMap(each -> change.apply(each).stream()).toList(),
              group.place()));
    }
    return robot.withGroups(groups);
  }
}
