package org.dfra.river.registrar;

import java.net.InetAddress;
import org.dfra.river.access.RemoteCaller;
import org.jspecify.annotations.Nullable;

/**
 * The computer that a registration comes from.
 *
 * @param address its address; null if unknown
 * @param isRobotHost whether it is one of the robot's hosts
 */
record RegistrationOrigin(@Nullable InetAddress address, boolean isRobotHost) {

  /** Whether a registration from here may replace one from another origin. */
  boolean mayReplace(RegistrationOrigin other) {
    return isRobotHost || (!other.isRobotHost && address != null && address.equals(other.address));
  }

  /** Its numeric address, or a substitute. */
  @Override
  public String toString() {
    return new RemoteCaller(address).toString();
  }
}
