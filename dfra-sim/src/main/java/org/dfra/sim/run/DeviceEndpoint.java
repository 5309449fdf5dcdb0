package org.dfra.sim.run;

import java.util.List;

/**
 * A line of a robot with an emulated device at its end.
 *
 * @param robot name of the robot
 * @param device name of the device, as the world's description has it
 * @param protocol what it speaks, e.g. {@code m12}
 * @param link where a driver finds it, e.g. {@code tcp://127.0.0.1:4101}
 * @param servedDevices names of the devices that are reached by this line; its own is the first
 */
public record DeviceEndpoint(
    String robot, String device, String protocol, String link, List<String> servedDevices) {

  public DeviceEndpoint {
    servedDevices = List.copyOf(servedDevices);
  }

  /** {@code DFRA_ATRV1_LASER_LINK}: the variable by which a robot's XML is told the link. */
  public String linkVariable() {
    return "DFRA_" + (robot + "_" + device).toUpperCase(java.util.Locale.ROOT) + "_LINK";
  }
}
