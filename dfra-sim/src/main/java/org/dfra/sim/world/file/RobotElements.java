package org.dfra.sim.world.file;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import org.dfra.core.config.NearestName;
import org.dfra.core.config.RenamedNames;
import org.dfra.core.config.XmlValues;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceDescription.EmulatorDescription;
import org.dfra.sim.world.description.DeviceDescription.MountPose;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.jdom2.Element;

/** Reads the robots of a world with their devices, and the defaults of each kind of device. */
final class RobotElements {

  private final XmlValues values;
  private final XmlNumberParser numbers;
  private final Map<DeviceKind, Map<String, Double>> defaults = new EnumMap<>(DeviceKind.class);

  RobotElements(XmlValues values, XmlNumberParser numbers) {
    this.values = values;
    this.numbers = numbers;
  }

  /** Reads the defaults of each kind of device; call it before reading the robots. */
  void defaults(Element element) {
    kind(element)
        .ifPresent(
            kind -> {
              Map<String, Double> of = defaults.computeIfAbsent(kind, k -> new TreeMap<>());
              parameters(element, kind, "the defaults of " + kind.text())
                  .forEach(
                      (name, value) -> {
                        if (kind.parameter(name).isPresent()) {
                          of.put(name, value);
                        } else {
                          values.check(element, unknown(kind, name));
                        }
                      });
            });
  }

  private static String unknown(DeviceKind kind, String name) {
    List<String> known = kind.parameters().stream().map(one -> one.name()).toList();
    return "a "
        + kind.text()
        + " has no parameter "
        + name
        + NearestName.hint(name, known, "; it has " + String.join(", ", known));
  }

  /** The robot; empty, with the reason among the faults, if its type is unknown. */
  Optional<VehicleDescription> robot(Element element) {
    String name = values.attribute(element, "name", "");
    List<DeviceDescription> devices = new ArrayList<>();
    for (Element device : element.getChildren("device", WorldXml.SCHEMA.namespace())) {
      device(device).ifPresent(devices::add);
    }
    Optional<VehicleType> known = choice(element, "type", VehicleType.values(), VehicleType::text);
    if (name == null || known.isEmpty()) {
      return Optional.empty();
    }
    VehicleType type = known.get();
    return Optional.of(
        new VehicleDescription(
            name,
            type,
            numbers.number(element, "east", 0),
            numbers.number(element, "north", 0),
            numbers.number(element, "yaw", 0),
            numbers.number(element, "length", type.length()),
            numbers.number(element, "width", type.width()),
            numbers.number(element, "height", type.height()),
            devices,
            values.place(element)));
  }

  private Optional<DeviceDescription> device(Element element) {
    Optional<DeviceKind> kind = kind(element);
    String name = values.attribute(element, "name", "");
    MountPose mount =
        new MountPose(
            numbers.number(element, "x", 0),
            numbers.number(element, "y", 0),
            numbers.number(element, "z", 0),
            numbers.number(element, "roll", 0),
            numbers.number(element, "pitch", 0),
            numbers.number(element, "yaw", 0));
    if (kind.isEmpty() || name == null) {
      return Optional.empty();
    }
    Map<String, Double> parameters = new TreeMap<>(defaults.getOrDefault(kind.get(), Map.of()));
    parameters.putAll(parameters(element, kind.get(), name));
    return Optional.of(
        new DeviceDescription(
            kind.get(),
            name,
            mount,
            Optional.ofNullable(values.attribute(element, "parent")),
            parameters,
            new EmulatorDescription(
                Optional.ofNullable(values.attribute(element, "protocol")),
                Optional.ofNullable(values.attribute(element, "link")),
                Optional.ofNullable(values.attribute(element, "port")),
                Optional.ofNullable(values.attribute(element, "baud"))),
            values.place(element)));
  }

  private Optional<DeviceKind> kind(Element element) {
    return choice(element, "kind", DeviceKind.values(), DeviceKind::text);
  }

  private Map<String, Double> parameters(Element element, DeviceKind kind, String of) {
    String scope = RenamedNames.parametersOfDevice(kind.text());
    Map<String, Double> parameters = new TreeMap<>();
    XmlValues.UniqueNames names = values.uniqueNames();
    for (Element child : element.getChildren("parameter", WorldXml.SCHEMA.namespace())) {
      String written = values.attribute(child, "name", "");
      if (written != null) {
        String name = RenamedNames.resolve(scope, values.place(child), "the parameter", written);
        names.requireFirst(child, name, "parameter " + name + " of " + of, "delete one");
        parameters.put(name, numbers.number(child, "value", 0));
      }
    }
    return parameters;
  }

  /** One of several words; any other word is a fault. */
  private <T> Optional<T> choice(
      Element element, String attribute, T[] all, Function<T, String> text) {
    String written = values.attribute(element, attribute);
    if (written == null) {
      return Optional.empty();
    }
    Optional<T> chosen =
        Arrays.stream(all).filter(one -> text.apply(one).equals(written)).findFirst();
    if (chosen.isEmpty()) {
      List<String> known = Arrays.stream(all).map(text).toList();
      values.check(
          element,
          attribute
              + " is \""
              + written
              + "\", which is unknown"
              + NearestName.hint(written, known, "; write " + String.join(", ", known)));
    }
    return chosen;
  }
}
