package org.dfra.sim.run;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dfra.core.config.ConfigurationException;
import org.dfra.sim.device.Cable;
import org.dfra.sim.device.SerialDevice;
import org.dfra.sim.device.drive.RflexDevice;
import org.dfra.sim.time.LockStep;
import org.dfra.sim.world.SimulatedRobot;
import org.dfra.sim.world.World;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.WorldDescription;

/**
 * A world in which an emulated device serves every link of every robot.
 *
 * <p>{@link #start} opens the links; {@link #close} closes them. Both are idempotent. The world
 * advances to the times that its devices and the callers of {@link World#groundTruth} request.
 */
public final class Simulation implements AutoCloseable {

  /** Selects a device's TCP port. */
  public enum PortPolicy {
    /** The port in the description, or any free one where none is given. */
    CONFIGURED,
    /** Any free one. */
    EPHEMERAL
  }

  private record Emulated(
      SimulatedRobot robot, EmulatorFactory.EmulatedLink line, EmulatorTransport carrier) {
    DeviceEndpoint endpoint() {
      return new DeviceEndpoint(
          robot.name(),
          line.device().name(),
          line.protocol(),
          carrier.link(),
          line.serves().stream().map(DeviceDescription::name).toList());
    }
  }

  private interface Carriers {
    EmulatorTransport create(String name, DeviceDescription device, SerialDevice emulated);
  }

  private final World world;
  private final Map<String, Emulated> emulated = new TreeMap<>(); // by robot/device

  @GuardedBy("this")
  private boolean started;

  private Simulation(World world, Carriers carriers) {
    this.world = world;
    for (SimulatedRobot robot : world.robots()) {
      for (EmulatorFactory.EmulatedLink line :
          EmulatorFactory.links(robot, world.description().datum())) {
        String name = robot.name() + "/" + line.device().name();
        emulated.put(
            name, new Emulated(robot, line, carriers.create(name, line.device(), line.emulated())));
      }
    }
  }

  /**
   * Devices behind TCP ports of the loopback interface, with a clock that may run at any speed.
   *
   * @throws ConfigurationException if the description of a device's emulator is invalid
   */
  public static Simulation overTcp(
      WorldDescription description, InstantSource clock, PortPolicy ports) {
    return new Simulation(
        World.of(description, clock.instant()),
        (name, device, emulated) ->
            EmulatorTransport.tcp(
                name,
                ports == PortPolicy.EPHEMERAL ? 0 : EmulatorFactory.port(device),
                emulated,
                clock));
  }

  /**
   * Devices at {@code sim:robot/device}, in lock-step with their drivers: the same seed and the
   * same commands give the same bytes.
   *
   * @throws ConfigurationException if the description of a device's emulator is invalid
   */
  public static Simulation inLockStep(WorldDescription description, LockStep time) {
    return new Simulation(
        World.of(description, time.instant()),
        (name, device, emulated) -> EmulatorTransport.lockStep(name, emulated, time));
  }

  /**
   * Opens every link, or none.
   *
   * @throws IOException if one cannot be opened; the message names it and the place of its
   *     description
   */
  public synchronized void start() throws IOException {
    if (started) {
      return;
    }
    started = true;
    List<EmulatorTransport> opened = new ArrayList<>();
    for (Map.Entry<String, Emulated> each : emulated.entrySet()) {
      try {
        each.getValue().carrier().start();
        opened.add(each.getValue().carrier());
      } catch (IOException e) {
        opened.forEach(EmulatorTransport::close);
        throw new IOException(
            each.getValue().line().device().place()
                + ": "
                + each.getKey()
                + " cannot be reached: "
                + e.getMessage(),
            e);
      }
    }
  }

  /** The world. */
  public World world() {
    return world;
  }

  /** Every link, by robot and device; only while started. */
  public List<DeviceEndpoint> endpoints() {
    return emulated.values().stream().map(Emulated::endpoint).toList();
  }

  /**
   * The cable of a link, for fault injection.
   *
   * @throws IllegalArgumentException if there is no such link
   */
  public Cable cable(String robot, String device) {
    return link(robot, device).carrier().cable();
  }

  /**
   * An rFLEX controller, to see which commands reach it and when.
   *
   * @throws IllegalArgumentException if there is no such link, or another device behind it
   */
  public RflexDevice driveController(String robot, String device) {
    if (link(robot, device).line().emulated() instanceof RflexDevice controller) {
      return controller;
    }
    throw new IllegalArgumentException(robot + "/" + device + " is not an rFLEX controller");
  }

  private Emulated link(String robot, String device) {
    Emulated link = emulated.get(robot + "/" + device);
    if (link == null) {
      throw new IllegalArgumentException(
          "there is no link to "
              + robot
              + "/"
              + device
              + "; there are links to "
              + emulated.keySet());
    }
    return link;
  }

  @Override
  public void close() {
    emulated.values().forEach(each -> each.carrier().close());
  }

  /**
   * A link of a robot to an emulated device.
   *
   * @param robot name of the robot
   * @param device name of the device, as the world's description has it
   * @param protocol of the device, e.g. {@code m12}
   * @param link for a driver, e.g. {@code tcp://127.0.0.1:4101}
   * @param servedDevices names of the devices on this link; its own is the first
   */
  public record DeviceEndpoint(
      String robot, String device, String protocol, String link, List<String> servedDevices) {

    public DeviceEndpoint {
      servedDevices = List.copyOf(servedDevices);
    }

    /** {@code DFRA_ATRV1_LASER_LINK}: the variable that passes the link to a robot's XML. */
    public String linkVariable() {
      return "DFRA_" + (robot + "_" + device).toUpperCase(java.util.Locale.ROOT) + "_LINK";
    }
  }
}
