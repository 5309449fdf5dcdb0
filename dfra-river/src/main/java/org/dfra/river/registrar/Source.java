package org.dfra.river.registrar;

import java.net.InetAddress;
import org.dfra.river.access.Caller;
import org.jspecify.annotations.Nullable;

/**
 * The computer that a registration comes from.
 *
 * @param address its address; null where it is not known
 * @param own whether it is one of the robot's own computers
 */
record Source(@Nullable InetAddress address, boolean own) {

  /** Whether a registration from here may take the place of one from another source. */
  boolean mayReplace(Source other) {
    return own || (!other.own && address != null && address.equals(other.address));
  }

  /** Its address in digits, or what stands for it. */
  @Override
  public String toString() {
    return new Caller(address).toString();
  }
}
