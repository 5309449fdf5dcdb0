package org.dfra.sim.run;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.NearestName;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.device.SerialDevice;
import org.dfra.sim.device.camera.MjpegDevice;
import org.dfra.sim.device.camera.MjpegDevice.MjpegOptions;
import org.dfra.sim.device.drive.RflexDevice;
import org.dfra.sim.device.gps.AntennaTrajectory;
import org.dfra.sim.device.gps.GpsdDevice;
import org.dfra.sim.device.gps.M12Device;
import org.dfra.sim.device.gps.NmeaDevice;
import org.dfra.sim.device.gps.UbxDevice;
import org.dfra.sim.device.gyro.Dsp3000Device;
import org.dfra.sim.device.laser.LmsDevice;
import org.dfra.sim.device.laser.LmsEmulatorSettings;
import org.dfra.sim.device.pantilt.PtuDevice;
import org.dfra.sim.device.uav.AutopilotDevice;
import org.dfra.sim.device.uav.AutopilotSettings;
import org.dfra.sim.device.uav.AutopilotSettings.AutopilotSoftware;
import org.dfra.sim.physics.BatteryPhysics;
import org.dfra.sim.world.SimulatedRobot;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceKind;

/**
 * Creates the emulator of each link of a robot, by the kinds of its devices and the protocols that
 * their descriptions name.
 */
final class EmulatorFactory {

  /** Protocol of a receiver without a link of its own: the flight controller reports its data. */
  private static final String MAVLINK = "mavlink";

  private static final List<String> RECEIVERS = List.of("m12", "nmea", "ubx", "gpsd", MAVLINK);
  private static final int RECEIVER_BAUD = 9600;
  private static final int PAN_TILT_BAUD = 9600;
  private static final int GYRO_BAUD = 38400;

  /** Default images per second of visible and thermal cameras. */
  private static final double CAMERA_RATE = 10;

  private static final double THERMAL_RATE = 5;

  /** Battery of a robot whose description has none. */
  private static final BatteryPhysics MAINS = time -> new BatteryPhysics.Charge(24, 0, 1);

  private EmulatorFactory() {}

  /**
   * A link and its emulator.
   *
   * @param device that owns the link
   * @param protocol of the link
   * @param serves the devices on the link, its own first
   */
  record EmulatedLink(
      DeviceDescription device,
      String protocol,
      List<DeviceDescription> serves,
      SerialDevice emulated) {}

  /**
   * The links of a robot, in the order of its devices.
   *
   * @param datum origin of the world's frame
   */
  static List<EmulatedLink> links(SimulatedRobot robot, GeoPosition datum) {
    List<EmulatedLink> lines = new ArrayList<>();
    for (DeviceDescription device : robot.description().devices()) {
      link(robot, datum, device).ifPresent(lines::add);
    }
    return lines;
  }

  private static Optional<EmulatedLink> link(
      SimulatedRobot robot, GeoPosition datum, DeviceDescription device) {
    String name = device.name();
    return switch (device.kind()) {
      case GPS ->
          protocol(device, RECEIVERS).equals(MAVLINK)
              ? Optional.empty()
              : Optional.of(receiver(robot, device));
      case LASER ->
          link(
              device,
              "lms200",
              new LmsDevice(robot.laser(name), LmsEmulatorSettings.factoryDefault()));
      case DRIVE -> Optional.of(wheels(robot, device));
      case PAN_TILT ->
          link(
              device,
              "ptu46",
              new PtuDevice(robot.panTilt(name), baud(device, PAN_TILT_BAUD), false));
      case GYRO ->
          link(
              device,
              "dsp3000",
              new Dsp3000Device(robot.gyro(name), baud(device, GYRO_BAUD), Duration.ZERO));
      case CAMERA ->
          link(
              device,
              "mjpeg",
              new MjpegDevice(robot.camera(name), MjpegOptions.visible(CAMERA_RATE)));
      case THERMAL ->
          link(
              device,
              "mjpeg",
              new MjpegDevice(robot.camera(name), MjpegOptions.thermal(THERMAL_RATE)));
      case FLIGHT -> Optional.of(autopilot(robot, datum, device));
      case BATTERY -> Optional.empty(); // the device that it powers reports it
    };
  }

  /** A link that serves its own device with the only protocol of its kind. */
  private static Optional<EmulatedLink> link(
      DeviceDescription device, String protocol, SerialDevice emulated) {
    return Optional.of(
        new EmulatedLink(device, protocol(device, List.of(protocol)), List.of(device), emulated));
  }

  private static EmulatedLink wheels(SimulatedRobot robot, DeviceDescription device) {
    List<DeviceDescription> serves = new ArrayList<>(List.of(device));
    serves.addAll(ofKind(robot, DeviceKind.BATTERY));
    return new EmulatedLink(
        device,
        protocol(device, List.of("rflex")),
        serves,
        new RflexDevice(robot.drivetrain(device.name()), battery(robot)));
  }

  private static EmulatedLink autopilot(
      SimulatedRobot robot, GeoPosition datum, DeviceDescription device) {
    List<DeviceDescription> serves = new ArrayList<>(List.of(device));
    List<DeviceDescription> receivers = ofKind(robot, DeviceKind.GPS);
    receivers.stream()
        .filter(each -> each.emulator().protocol().filter(MAVLINK::equals).isPresent())
        .forEach(serves::add);
    serves.addAll(ofKind(robot, DeviceKind.BATTERY));
    if (receivers.isEmpty()) {
      throw new ConfigurationException(
          device.place()
              + ": "
              + robot.name()
              + " flies with "
              + device.name()
              + " but has no gps; add <device kind=\"gps\" name=\"gps\" protocol=\""
              + MAVLINK
              + "\"/>");
    }
    return new EmulatedLink(
        device,
        protocol(device, List.of(MAVLINK)),
        serves,
        new AutopilotDevice(
            AutopilotSettings.of(AutopilotSoftware.ARDUPILOT),
            datum,
            robot.multicopter(device.name()),
            robot.antenna(receivers.get(0).name()),
            battery(robot)));
  }

  private static BatteryPhysics battery(SimulatedRobot robot) {
    return ofKind(robot, DeviceKind.BATTERY).stream()
        .findFirst()
        .map(each -> robot.battery(each.name()))
        .orElse(MAINS);
  }

  private static List<DeviceDescription> ofKind(SimulatedRobot robot, DeviceKind kind) {
    return robot.description().devices().stream().filter(each -> each.kind() == kind).toList();
  }

  private static EmulatedLink receiver(SimulatedRobot robot, DeviceDescription device) {
    String protocol = protocol(device, RECEIVERS);
    AntennaTrajectory path = robot.antenna(device.name());
    int baud = baud(device, RECEIVER_BAUD);
    SerialDevice emulated =
        switch (protocol) {
          case "nmea" -> new NmeaDevice(path, baud, Duration.ZERO);
          case "ubx" -> new UbxDevice(path, baud, Duration.ZERO);
          case "gpsd" -> new GpsdDevice(path, baud, Duration.ZERO);
          default -> new M12Device(path, baud, Duration.ZERO);
        };
    return new EmulatedLink(device, protocol, List.of(device), emulated);
  }

  /** The protocol given, one of those; the first where none is given. */
  private static String protocol(DeviceDescription device, List<String> known) {
    String written = device.emulator().protocol().orElse(known.get(0));
    if (!known.contains(written)) {
      throw new ConfigurationException(
          device.place()
              + ": a "
              + device.kind().text()
              + " does not support the protocol \""
              + written
              + "\""
              + NearestName.hint(written, known, "; use " + String.join(" or ", known)));
    }
    return written;
  }

  private static int baud(DeviceDescription device, int usual) {
    return device.emulator().baud().map(text -> whole(device, "baud", text)).orElse(usual);
  }

  /** The TCP port given; 0, any free one, where none is given. */
  static int port(DeviceDescription device) {
    return device.emulator().port().map(text -> whole(device, "port", text)).orElse(0);
  }

  private static int whole(DeviceDescription device, String what, String text) {
    try {
      return Integer.parseInt(text);
    } catch (NumberFormatException e) {
      throw new ConfigurationException(
          device.place()
              + ": "
              + what
              + " \""
              + text
              + "\" of "
              + device.name()
              + " is not a whole number",
          e);
    }
  }
}
