package org.dfra.sim.world;

import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.dfra.core.config.NearestName;
import org.dfra.sim.device.gps.AntennaTrajectory;
import org.dfra.sim.physics.BatteryPhysics;
import org.dfra.sim.physics.CameraInput;
import org.dfra.sim.physics.DrivetrainPhysics;
import org.dfra.sim.physics.GyroInput;
import org.dfra.sim.physics.MulticopterPhysics;
import org.dfra.sim.physics.PanTiltPhysics;
import org.dfra.sim.physics.RangeInput;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceDescription.MountPose;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.noise.CorrelatedNoise;
import org.dfra.sim.world.noise.RandomStream;
import org.jspecify.annotations.Nullable;

/**
 * A robot in a world, as seen by its devices' emulators: each gets its interface by the name of the
 * device. Each interface is created once. Any thread may call it.
 */
public final class SimulatedRobot {

  private final VehicleBody body;
  private final VehicleDescription vehicle;
  private final Map<String, Object> views = new HashMap<>(); // filled by the constructor

  SimulatedRobot(World world, VehicleBody body, StateLayout slots, List<SimulatedPanTilt> heads) {
    this.body = body;
    this.vehicle = body.vehicle;
    Map<String, SimulatedPanTilt> headsByName = new HashMap<>();
    for (DeviceDescription device : vehicle.devices()) {
      if (device.kind() == DeviceKind.PAN_TILT) {
        SimulatedPanTilt head = new SimulatedPanTilt(world, slots);
        heads.add(head);
        headsByName.put(device.name(), head);
        views.put(device.name(), head);
      }
    }
    for (DeviceDescription device : vehicle.devices()) {
      if (device.kind() != DeviceKind.PAN_TILT) {
        views.put(device.name(), view(world, device, mount(device, headsByName)));
      }
    }
  }

  private DeviceMount mount(DeviceDescription device, Map<String, SimulatedPanTilt> heads) {
    @Nullable MountPose foot =
        device.parent().flatMap(vehicle::device).map(DeviceDescription::mount).orElse(null);
    return new DeviceMount(
        body, device.mount(), foot, device.parent().map(heads::get).orElse(null));
  }

  private Object view(World world, DeviceDescription device, DeviceMount mount) {
    RandomStream draws = body.draws.substream(device.name());
    return switch (device.kind()) {
      case GPS -> new SimulatedGpsAntenna(world, mount, device, draws);
      case LASER -> new SimulatedLaser(world, mount, device, draws);
      case DRIVE -> new SimulatedDrivetrain(world, (SkidSteerBody) body);
      case GYRO -> new SimulatedGyro(world, mount, device, draws);
      case BATTERY -> new SimulatedBattery(world, body);
      case FLIGHT -> new SimulatedMulticopter(world, (MulticopterBody) body);
      case CAMERA, THERMAL -> new SimulatedCamera(world, mount, device, draws);
      case PAN_TILT -> throw new IllegalStateException("the pan-tilt unit was created before");
    };
  }

  /** Its name. */
  public String name() {
    return vehicle.name();
  }

  /** Its description. */
  public VehicleDescription description() {
    return vehicle;
  }

  VehicleBody body() {
    return body;
  }

  /** The antenna of a receiver, with measurement errors. */
  public AntennaTrajectory antenna(String gps) {
    return view(gps, AntennaTrajectory.class, DeviceKind.GPS);
  }

  /** The ranges of a laser. */
  public RangeInput laser(String laser) {
    return view(laser, RangeInput.class, DeviceKind.LASER);
  }

  /** Its wheels. */
  public DrivetrainPhysics drivetrain(String drive) {
    return view(drive, DrivetrainPhysics.class, DeviceKind.DRIVE);
  }

  /** The rates of a gyro. */
  public GyroInput gyro(String gyro) {
    return view(gyro, GyroInput.class, DeviceKind.GYRO);
  }

  /** The images of a visible-light or thermal camera. */
  public CameraInput camera(String camera) {
    return simulatedCamera(camera);
  }

  SimulatedCamera simulatedCamera(String camera) {
    return view(camera, SimulatedCamera.class, DeviceKind.CAMERA, DeviceKind.THERMAL);
  }

  /** The head of a pan-tilt unit. */
  public PanTiltPhysics panTilt(String panTilt) {
    return view(panTilt, PanTiltPhysics.class, DeviceKind.PAN_TILT);
  }

  /** Its battery. */
  public BatteryPhysics battery(String battery) {
    return view(battery, BatteryPhysics.class, DeviceKind.BATTERY);
  }

  /** Its rotors under their autopilot. */
  public MulticopterPhysics multicopter(String flight) {
    return view(flight, MulticopterPhysics.class, DeviceKind.FLIGHT);
  }

  private <T> T view(String device, Class<T> type, DeviceKind... kinds) {
    Optional<DeviceDescription> found = vehicle.device(device);
    List<DeviceKind> requested = List.of(kinds);
    if (found.isPresent() && requested.contains(found.get().kind())) {
      return type.cast(Objects.requireNonNull(views.get(device), "each device has a view"));
    }
    List<String> names =
        vehicle.devices().stream()
            .filter(one -> requested.contains(one.kind()))
            .map(DeviceDescription::name)
            .toList();
    throw new IllegalArgumentException(
        name()
            + " has no "
            + requested.get(0).text()
            + " \""
            + device
            + "\""
            + (names.isEmpty()
                ? "; it has none"
                : NearestName.hint(device, names, "; it has " + names)));
  }

  /** The battery of a robot, measured at its terminals. */
  private static final class SimulatedBattery implements BatteryPhysics {

    private final World world;
    private final int offset;

    SimulatedBattery(World world, VehicleBody body) {
      this.world = world;
      this.offset = Objects.requireNonNull(body.battery, "a robot with a battery").offset;
    }

    @Override
    public Charge at(Instant time) {
      synchronized (world.monitor()) {
        double[] row = world.row(world.stepAt(time));
        return new Charge(
            row[offset + BatteryModel.VOLTAGE],
            row[offset + BatteryModel.CURRENT],
            row[offset + BatteryModel.REMAINING]);
      }
    }
  }

  /**
   * A rate gyro: the yaw rate of its robot about its own z axis, an initial bias that drifts, and
   * white noise. It does not measure roll and pitch rates on rough ground or the motion of a
   * pan-tilt head.
   */
  private static final class SimulatedGyro implements GyroInput {

    private final World world;
    private final DeviceMount mount;
    private final CorrelatedNoise bias;
    private final RandomStream draws;
    private final double white;

    SimulatedGyro(World world, DeviceMount mount, DeviceDescription device, RandomStream draws) {
      VehicleType type = mount.body().vehicle.type();
      this.world = world;
      this.mount = mount;
      this.draws = draws.substream("white");
      this.white = device.parameter("white_noise_sigma", type);
      double first = device.parameter("bias_sigma", type) * draws.substream("bias").gaussian(0);
      this.bias =
          CorrelatedNoise.walk(
              draws.substream("drift"),
              first,
              device.parameter("bias_random_walk", type),
              World.STEP_SECONDS);
    }

    @Override
    public double rate(Instant time) {
      synchronized (world.monitor()) {
        long step = world.stepAt(time);
        double[] row = world.row(step);
        double rate = row[mount.body().offset + VehicleBody.RATE] * mount.at(row).zz;
        return rate + bias.at(step) + white * draws.gaussian(step);
      }
    }
  }
}
