package org.dfra.sim.world.description;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.NearestName;
import org.dfra.core.config.SourceLocation;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.jspecify.annotations.Nullable;

/**
 * A device on a robot.
 *
 * @param kind of device
 * @param name unique on its robot, in lower_snake_case
 * @param mount pose on the robot, or on its parent
 * @param parent the pan-tilt unit that carries it, if any
 * @param parameters the numbers that differ from the kind's own
 * @param emulator settings of its emulator
 * @param place its source location
 */
public record DeviceDescription(
    DeviceKind kind,
    String name,
    DeviceDescription.MountPose mount,
    Optional<String> parent,
    Map<String, Double> parameters,
    DeviceDescription.EmulatorDescription emulator,
    SourceLocation place) {

  public DeviceDescription {
    parameters = Map.copyOf(parameters);
  }

  /** With the kind's defaults, on the robot itself. */
  public DeviceDescription(DeviceKind kind, String name, MountPose mount) {
    this(
        kind,
        name,
        mount,
        Optional.empty(),
        Map.of(),
        EmulatorDescription.NONE,
        SourceLocation.CODE);
  }

  /**
   * The same device with one number changed.
   *
   * @throws ConfigurationException if the kind has no such parameter
   */
  public DeviceDescription with(String parameter, double value) {
    if (kind.parameter(parameter).isEmpty()) {
      throw unknown(parameter);
    }
    Map<String, Double> changed = new TreeMap<>(parameters);
    changed.put(parameter, value);
    return new DeviceDescription(kind, name, mount, parent, changed, emulator, place);
  }

  /** The same device carried by a pan-tilt unit. */
  public DeviceDescription mountedOn(String panTilt) {
    return new DeviceDescription(
        kind, name, mount, Optional.of(panTilt), parameters, emulator, place);
  }

  /** A parameter: its own value, or the kind's default for robots of that type. */
  public double parameter(String parameter, VehicleType type) {
    Double own = parameters.get(parameter);
    if (own != null) {
      return own;
    }
    return kind.parameter(parameter).orElseThrow(() -> unknown(parameter)).defaultFor(type);
  }

  private ConfigurationException unknown(String parameter) {
    return new ConfigurationException(
        place
            + ": "
            + kind.text()
            + " has no parameter "
            + parameter
            + NearestName.hint(
                parameter, kind.parameters().stream().map(DeviceParameter::name).toList(), ""));
  }

  /**
   * A numeric parameter of a kind of device.
   *
   * @param name in lower_snake_case
   * @param ugvDefault default on a UGV
   * @param uavDefault default on a UAV
   * @param min minimum
   * @param max maximum
   * @param unit its unit; empty for a plain number
   * @param meaning its description, half a sentence
   */
  public record DeviceParameter(
      String name,
      double ugvDefault,
      double uavDefault,
      double min,
      double max,
      String unit,
      String meaning) {

    /** Its default. */
    public double defaultFor(VehicleType type) {
      return type == VehicleType.UAV ? uavDefault : ugvDefault;
    }

    /** The error of this value and how to correct it; null if it is valid. */
    public @Nullable String violation(double value) {
      String of = unit.isEmpty() ? "" : " " + unit;
      return value >= min && value <= max
          ? null
          : name + " is " + value + of + "; write a number from " + min + " to " + max + of;
    }
  }

  /**
   * Settings of a device's emulator; the world stores them unchanged.
   *
   * @param protocol its protocol, such as {@code m12}
   * @param link its link, such as {@code sim:atrv1/gps_front}
   * @param port TCP port on which it listens
   * @param baud bits per second of its serial line
   */
  public record EmulatorDescription(
      Optional<String> protocol,
      Optional<String> link,
      Optional<String> port,
      Optional<String> baud) {

    /** No settings. */
    public static final EmulatorDescription NONE =
        new EmulatorDescription(
            Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty());
  }

  /**
   * Pose of a device on its carrier: rotated first by roll about x, then by pitch about y, then by
   * yaw about z, each about an axis of the carrier.
   *
   * @param x forward, metres
   * @param y to the left, metres
   * @param z up, metres; on a robot above its base
   * @param roll radians, left side up is +
   * @param pitch radians, nose down is +
   * @param yaw radians, to the left is +
   */
  public record MountPose(double x, double y, double z, double roll, double pitch, double yaw) {

    /** At the origin of its carrier, not rotated. */
    public static final MountPose MIDDLE = new MountPose(0, 0, 0, 0, 0, 0);

    public MountPose {
      if (!Double.isFinite(x + y + z + roll + pitch + yaw)) {
        throw new IllegalArgumentException(
            "the mount ("
                + x
                + ", "
                + y
                + ", "
                + z
                + ") m, ("
                + roll
                + ", "
                + pitch
                + ", "
                + yaw
                + ") rad is not finite");
      }
    }

    /** Not rotated. */
    public static MountPose at(double x, double y, double z) {
      return new MountPose(x, y, z, 0, 0, 0);
    }
  }
}
