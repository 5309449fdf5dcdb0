package org.dfra.sim.world.description;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dfra.core.config.SourceLocation;

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
    VehicleDescription.VehicleType type,
    double east,
    double north,
    double yaw,
    double length,
    double width,
    double height,
    List<DeviceDescription> devices,
    SourceLocation place) {

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
        SourceLocation.CODE);
  }

  /** The same robot with one device more. */
  public VehicleDescription with(DeviceDescription device) {
    List<DeviceDescription> more = new ArrayList<>(devices);
    more.add(device);
    return withDevices(more);
  }

  /** The same robot with other devices. */
  public VehicleDescription withDevices(List<DeviceDescription> others) {
    return new VehicleDescription(
        name, type, east, north, yaw, length, width, height, others, place);
  }

  /** The same robot at another place, in metres and radians. */
  public VehicleDescription withPose(double otherEast, double otherNorth, double otherYaw) {
    return new VehicleDescription(
        name, type, otherEast, otherNorth, otherYaw, length, width, height, devices, place);
  }

  /** The device of that name, if it has one. */
  public Optional<DeviceDescription> device(String device) {
    return devices.stream().filter(one -> one.name().equals(device)).findFirst();
  }

  /** The first device of that kind, if it has one. */
  public Optional<DeviceDescription> device(DeviceKind kind) {
    return devices.stream().filter(one -> one.kind() == kind).findFirst();
  }

  /** Type of a robot's drive, with its default size. */
  public enum VehicleType {
    /** On four wheels, skid-steered; the size of an ATRV-Jr. */
    UGV(0.78, 0.64, 0.55),
    /** A multicopter. */
    UAV(0.6, 0.6, 0.25);

    private final double length;
    private final double width;
    private final double height;

    VehicleType(double length, double width, double height) {
      this.length = length;
      this.width = width;
      this.height = height;
    }

    /** Along its x axis, metres. */
    public double length() {
      return length;
    }

    /** Along its y axis, metres. */
    public double width() {
      return width;
    }

    /** From its base to its top, without masts, metres. */
    public double height() {
      return height;
    }

    /** Its name in XML: {@code ugv}, {@code uav}. */
    public String text() {
      return name().toLowerCase(Locale.ROOT);
    }
  }
}
