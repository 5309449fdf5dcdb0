package org.dfra.river.registrar;

import java.net.InetAddress;
import org.dfra.river.access.RemoteCaller;
import org.jspecify.annotations.Nullable;

/**
 * The computer that a registration comes from.
 *
 * @param address its address; null where it is not known
 * @param isRobotHost whether it is one of the robot's own computers
 */
record RegistrationOrigin(@Nullable InetAddress address, boolean isRobotHost) {

  /** Whether a registration from here may take the place of one from another source. */
  boolean mayReplace(RegistrationOrigin other) {
    return isRobotHost || (!other.isRobotHost && address != null && address.equals(other.address));
  }

  /** Its address in digits, or what stands for it. */
  @Override
  public String toString() {
    return new RemoteCaller(address).toString();
  }
}
