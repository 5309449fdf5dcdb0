package org.dfra.sim.world.description;

import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.dfra.core.config.ConfigurationFaults;
import org.dfra.core.config.DescriptionRules;
import org.dfra.core.config.NearestName;
import org.dfra.sim.world.description.DeviceDescription.DeviceParameter;
import org.dfra.sim.world.description.DeviceDescription.MountPose;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;

/** Validates the devices of a robot. */
final class DeviceRules {

  /** Kinds of which a robot has at most one. */
  private static final Set<DeviceKind> SINGLE =
      EnumSet.of(DeviceKind.DRIVE, DeviceKind.FLIGHT, DeviceKind.BATTERY);

  private static final double MOST_TILT = Math.toRadians(60);

  private DeviceRules() {}

  static void check(VehicleDescription robot, ConfigurationFaults faults) {
    Set<String> names = new HashSet<>();
    Set<DeviceKind> kinds = EnumSet.noneOf(DeviceKind.class);
    for (DeviceDescription device : robot.devices()) {
      String kind = device.kind().text();
      Optional<String> isSecond =
          names.add(device.name())
              ? Optional.empty()
              : Optional.of("a second device " + device.name() + "; rename or delete one");
      Optional<String> isOneTooMany =
          kinds.add(device.kind()) || !SINGLE.contains(device.kind())
              ? Optional.empty()
              : Optional.of("a second " + kind + "; delete one");
      Stream.of(
              Optional.ofNullable(DescriptionRules.name("device", device.name())),
              isSecond.map(what -> robot.name() + " has " + what),
              isOneTooMany.map(what -> robot.name() + " has " + what),
              onType(robot, device),
              parent(robot, device),
              tilt(device))
          .flatMap(Optional::stream)
          .forEach(sentence -> faults.add(device.place(), sentence));
      new TreeMap<>(device.parameters())
          .forEach(
              (name, value) ->
                  parameter(device, name, value)
                      .ifPresent(sentence -> faults.add(device.place(), sentence)));
    }
  }

  private static Optional<String> onType(VehicleDescription robot, DeviceDescription device) {
    boolean isInTheAir = robot.type() == VehicleType.UAV;
    if (device.kind() != (isInTheAir ? DeviceKind.DRIVE : DeviceKind.FLIGHT)) {
      return Optional.empty();
    }
    VehicleType other = isInTheAir ? VehicleType.UGV : VehicleType.UAV;
    return Optional.of(
        robot.name()
            + " is a "
            + robot.type().text()
            + " and cannot have a "
            + device.kind().text()
            + "; delete it, or make the robot a "
            + other.text());
  }

  private static Optional<String> parent(VehicleDescription robot, DeviceDescription device) {
    if (device.parent().isEmpty()) {
      return Optional.empty();
    }
    String parent = device.parent().get();
    String prefix = device.name() + " is mounted on " + parent + ", ";
    if (device.kind() == DeviceKind.PAN_TILT) {
      return Optional.of(
          prefix + "but a pan-tilt is mounted on the robot itself; delete its parent");
    }
    List<String> heads =
        robot.devices().stream()
            .filter(other -> other.kind() == DeviceKind.PAN_TILT)
            .map(DeviceDescription::name)
            .toList();
    String otherwise =
        heads.isEmpty() ? "; it has none, so delete the parent" : "; it has " + heads;
    return heads.contains(parent)
        ? Optional.empty()
        : Optional.of(
            prefix
                + "which is not a pan-tilt of "
                + robot.name()
                + NearestName.hint(parent, heads, otherwise));
  }

  private static Optional<String> tilt(DeviceDescription device) {
    MountPose mount = device.mount();
    double cosine = Math.abs(Math.cos(mount.roll()) * Math.cos(mount.pitch()));
    return device.kind() == DeviceKind.LASER && cosine < Math.cos(MOST_TILT)
        ? Optional.of(
            device.name()
                + " is tilted by more than 60° from the level, which is not simulated; tilt it less")
        : Optional.empty();
  }

  private static Optional<String> parameter(
      DeviceDescription device, String parameter, double value) {
    List<String> known = device.kind().parameters().stream().map(DeviceParameter::name).toList();
    String otherwise =
        known.isEmpty() ? "; it has none, so delete it" : "; it has " + String.join(", ", known);
    String unknown =
        ("a " + device.kind().text() + " has no parameter " + parameter)
            + NearestName.hint(parameter, known, otherwise);
    return device
        .kind()
        .parameter(parameter)
        .map(found -> Optional.ofNullable(found.violation(value)))
        .orElse(Optional.of(unknown));
  }
}
