package org.dfra.sim.world;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.dfra.core.config.NearestName;
import org.dfra.sim.body.BatteryBody;
import org.dfra.sim.body.CameraView;
import org.dfra.sim.body.DriveBody;
import org.dfra.sim.body.FlightBody;
import org.dfra.sim.body.PanTiltBody;
import org.dfra.sim.body.RangeView;
import org.dfra.sim.body.TurnView;
import org.dfra.sim.device.AntennaPath;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.Mount;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.noise.Draws;
import org.jspecify.annotations.Nullable;

/**
 * A robot in a world, as its devices' emulators see it: each asks for its view by the name of the
 * device. Every view is made once. Any thread may ask.
 */
public final class SimulatedRobot {

  private final Body body;
  private final VehicleDescription vehicle;
  private final Map<String, Object> views = new HashMap<>(); // filled by the constructor

  SimulatedRobot(World world, Body body, Slots slots, List<Head> heads) {
    this.body = body;
    this.vehicle = body.vehicle;
    Map<String, Head> headsByName = new HashMap<>();
    for (DeviceDescription device : vehicle.devices()) {
      if (device.kind() == DeviceKind.PAN_TILT) {
        Head head = new Head(world, slots);
        heads.add(head);
        headsByName.put(device.name(), head);
        views.put(device.name(), head);
      }
    }
    for (DeviceDescription device : vehicle.devices()) {
      if (device.kind() != DeviceKind.PAN_TILT) {
        views.put(device.name(), view(world, device, rig(device, headsByName)));
      }
    }
  }

  private Rig rig(DeviceDescription device, Map<String, Head> heads) {
    @Nullable Mount foot =
        device.parent().flatMap(vehicle::device).map(DeviceDescription::mount).orElse(null);
    return new Rig(body, device.mount(), foot, device.parent().map(heads::get).orElse(null));
  }

  private Object view(World world, DeviceDescription device, Rig rig) {
    Draws draws = body.draws.of(device.name());
    return switch (device.kind()) {
      case GPS -> new ReceiverView(world, rig, device, draws);
      case LASER -> new LaserView(world, rig, device, draws);
      case DRIVE -> new WheelsView(world, (GroundBody) body);
      case GYRO -> new GyroView(world, rig, device, draws);
      case BATTERY -> new ChargeView(world, body);
      case FLIGHT -> new PilotView(world, (AirBody) body);
      case CAMERA, THERMAL -> new CameraPicture(world, rig, device, draws);
      case PAN_TILT -> throw new IllegalStateException("a head was made before");
    };
  }

  /** What it is called. */
  public String name() {
    return vehicle.name();
  }

  /** What it is and carries. */
  public VehicleDescription description() {
    return vehicle;
  }

  Body body() {
    return body;
  }

  /** Where a receiver's antenna is, as the receiver finds out. */
  public AntennaPath antenna(String gps) {
    return view(gps, AntennaPath.class, DeviceKind.GPS);
  }

  /** What a laser sees. */
  public RangeView rangeView(String laser) {
    return view(laser, RangeView.class, DeviceKind.LASER);
  }

  /** Its wheels. */
  public DriveBody drive(String drive) {
    return view(drive, DriveBody.class, DeviceKind.DRIVE);
  }

  /** What a gyro feels. */
  public TurnView turnView(String gyro) {
    return view(gyro, TurnView.class, DeviceKind.GYRO);
  }

  /** What a camera, for light or for heat, sees. */
  public CameraView cameraView(String camera) {
    return picture(camera);
  }

  CameraPicture picture(String camera) {
    return view(camera, CameraPicture.class, DeviceKind.CAMERA, DeviceKind.THERMAL);
  }

  /** The head of a pan-tilt unit. */
  public PanTiltBody panTilt(String panTilt) {
    return view(panTilt, PanTiltBody.class, DeviceKind.PAN_TILT);
  }

  /** Its battery. */
  public BatteryBody battery(String battery) {
    return view(battery, BatteryBody.class, DeviceKind.BATTERY);
  }

  /** Its rotors under their autopilot. */
  public FlightBody flight(String flight) {
    return view(flight, FlightBody.class, DeviceKind.FLIGHT);
  }

  private <T> T view(String device, Class<T> type, DeviceKind... kinds) {
    Optional<DeviceDescription> found = vehicle.device(device);
    List<DeviceKind> wanted = List.of(kinds);
    if (found.isPresent() && wanted.contains(found.get().kind())) {
      return type.cast(Objects.requireNonNull(views.get(device), "each device has a view"));
    }
    List<String> names =
        vehicle.devices().stream()
            .filter(one -> wanted.contains(one.kind()))
            .map(DeviceDescription::name)
            .toList();
    throw new IllegalArgumentException(
        name()
            + " has no "
            + wanted.get(0).text()
            + " \""
            + device
            + "\""
            + (names.isEmpty()
                ? "; it has none"
                : NearestName.hint(device, names, "; it has " + names)));
  }
}
