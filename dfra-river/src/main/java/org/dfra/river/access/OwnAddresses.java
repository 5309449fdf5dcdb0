package org.dfra.river.access;

import java.net.Inet6Address;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.net.UnknownHostException;
import org.jspecify.annotations.Nullable;

/**
 * From which addresses the programs of a robot's own computer call it.
 *
 * <p>These are the addresses of the computer's network interfaces, 127.0.0.1 among them, and all
 * other loopback addresses where the robot is exported at an address that others reach: nobody else
 * can call from there.
 *
 * <p>Where the robot itself is exported at a loopback address, several computers may be simulated
 * on one, each with a loopback address. Then only that address and 127.0.0.1 are its own. The
 * latter is where the kernel lets a program call from that has bound its socket to no address,
 * whichever loopback address it calls.
 */
public final class OwnAddresses {

  private static final int IPV4_BYTES = 4;

  /** At which the robot is exported; null where others reach it. */
  private final @Nullable InetAddress loopback;

  private OwnAddresses(@Nullable InetAddress loopback) {
    this.loopback = loopback;
  }

  /** All of this computer: its whole loopback, and every interface. */
  public static OwnAddresses ofThisComputer() {
    return new OwnAddresses(null);
  }

  /**
   * Those of a robot that is exported at an address of this computer.
   *
   * @param host the address, or a name of it; null for all of the computer's addresses
   * @throws UnknownHostException if the name is not known
   */
  public static OwnAddresses exportedAt(@Nullable String host) throws UnknownHostException {
    if (host == null) {
      return ofThisComputer();
    }
    InetAddress address = InetAddress.getByName(host);
    return new OwnAddresses(address.isLoopbackAddress() ? address : null);
  }

  /**
   * Whether an address is one of them wherever on this computer the robot is exported: that of an
   * interface, or the loopback's default. Nothing is looked up.
   */
  public static boolean isAlwaysLocal(InetAddress address) {
    return address.isLoopbackAddress() ? isDefault(address) : isOfAnInterface(address);
  }

  /** Whether an address is one of them. Interfaces are read anew each time: addresses change. */
  public boolean contains(InetAddress address) {
    if (!address.isLoopbackAddress()) {
      return isOfAnInterface(address);
    }
    return loopback == null || loopback.equals(address) || isDefault(address);
  }

  /** Whether programs call from it that name no other: 127.0.0.1 and ::1. */
  private static boolean isDefault(InetAddress address) {
    byte[] bytes = address.getAddress();
    return bytes.length != IPV4_BYTES || (bytes[1] == 0 && bytes[2] == 0 && bytes[3] == 1);
  }

  /**
   * Whether an interface has it. A link-local address means another computer on each link, so it
   * must be that of the interface by which it came: on another link anybody may have it.
   */
  private static boolean isOfAnInterface(InetAddress address) {
    try {
      if (address instanceof Inet6Address scoped
          && scoped.isLinkLocalAddress()
          && scoped.getScopeId() != 0) {
        @Nullable NetworkInterface its = NetworkInterface.getByIndex(scoped.getScopeId());
        return its != null && its.inetAddresses().anyMatch(address::equals);
      }
      return NetworkInterface.getByInetAddress(address) != null;
    } catch (SocketException e) {
      return false; // the interfaces cannot be read
    }
  }
}
