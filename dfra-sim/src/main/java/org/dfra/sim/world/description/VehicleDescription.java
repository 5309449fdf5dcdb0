package org.dfra.sim.world.description;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dfra.core.config.Place;

/**
 * A robot in a world: its body, its initial pose, and its devices.
 *
 * @param name unique in its world, in lower_snake_case
 * @param type of its drive
 * @param east of its centre at the start, metres
 * @param north of its centre at the start, metres
 * @param yaw heading at the start, radians, 0 is east, counter-clockwise is +
 * @param length along its x axis, metres, above 0
 * @param width along its y axis, metres, above 0
 * @param height from its base, metres, above 0
 * @param devices in the order written
 * @param place its source location
 */
public record VehicleDescription(
    String name,
    VehicleType type,
    double east,
    double north,
    double yaw,
    double length,
    double width,
    double height,
    List<DeviceDescription> devices,
    Place place) {

  public VehicleDescription {
    devices = List.copyOf(devices);
  }

  /** Created in code, with its type's size, without devices. */
  public VehicleDescription(String name, VehicleType type, double east, double north, double yaw) {
    this(
        name,
        type,
        east,
        north,
        yaw,
        type.length(),
        type.width(),
        type.height(),
        List.of(),
        Place.CODE);
  }

  /** The same robot with one device more. */
  public VehicleDescription with(DeviceDescription device) {
    List<DeviceDescription> more = new ArrayList<>(devices);
    more.add(device);
    return new VehicleDescription(name, type, east, north, yaw, length, width, height, more, place);
  }

  /** The device of that name, if it has one. */
  public Optional<DeviceDescription> device(String device) {
    return devices.stream().filter(one -> one.name().equals(device)).findFirst();
  }

  /** The first device of that kind, if it has one. */
  public Optional<DeviceDescription> device(DeviceKind kind) {
    return devices.stream().filter(one -> one.kind() == kind).findFirst();
  }
}
