package org.dfra.sim.run;

import java.util.List;

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
