package org.dfra.sim.world.description;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.NearestName;
import org.dfra.core.config.Place;

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
    MountPose mount,
    Optional<String> parent,
    Map<String, Double> parameters,
    EmulatorDescription emulator,
    Place place) {

  public DeviceDescription {
    parameters = Map.copyOf(parameters);
  }

  /** With the kind's defaults, on the robot itself. */
  public DeviceDescription(DeviceKind kind, String name, MountPose mount) {
    this(kind, name, mount, Optional.empty(), Map.of(), EmulatorDescription.NONE, Place.CODE);
  }

  /** The same device with one number changed. */
  public DeviceDescription with(String parameter, double value) {
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
    return kind.parameter(parameter)
        .orElseThrow(
            () ->
                new ConfigurationException(
                    place
                        + ": "
                        + kind.text()
                        + " has no "
                        + parameter
                        + NearestName.hint(
                            parameter,
                            kind.parameters().stream().map(DeviceParameter::name).toList(),
                            "")))
        .defaultFor(type);
  }
}
