package org.dfra.river.access;

import java.net.Inet6Address;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.net.UnknownHostException;
import org.jspecify.annotations.Nullable;

/**
 * The addresses from which the programs of a robot's own computer call it.
 *
 * <p>These are the addresses of the computer's network interfaces, including 127.0.0.1. If the
 * robot is exported at an address that other computers reach, all other loopback addresses belong
 * to it too: no other computer can call from them.
 *
 * <p>If the robot is exported at a loopback address, several computers may be simulated on one,
 * each with a loopback address. Then only that address and 127.0.0.1 are its own. The kernel uses
 * 127.0.0.1 as the source address of a program that has not bound its socket, whichever loopback
 * address it calls.
 */
public final class OwnAddresses {

  private static final int IPV4_BYTES = 4;

  /** The robot's loopback address; null if other computers reach the robot. */
  private final @Nullable InetAddress loopback;

  private OwnAddresses(@Nullable InetAddress loopback) {
    this.loopback = loopback;
  }

  /** The addresses of this computer: its whole loopback, and every interface. */
  public static OwnAddresses ofThisComputer() {
    return new OwnAddresses(null);
  }

  /**
   * The addresses of a robot that is exported at an address of this computer.
   *
   * @param host the address, or a name of it; null for all of the computer's addresses
   * @throws UnknownHostException if the name is unknown
   */
  public static OwnAddresses exportedAt(@Nullable String host) throws UnknownHostException {
    if (host == null) {
      return ofThisComputer();
    }
    InetAddress address = InetAddress.getByName(host);
    return new OwnAddresses(address.isLoopbackAddress() ? address : null);
  }

  /**
   * Whether an address is local, independent of the robot's own address on this computer: that of
   * an interface, or the loopback's default. Nothing is resolved.
   */
  public static boolean isAlwaysLocal(InetAddress address) {
    return address.isLoopbackAddress() ? isDefault(address) : isOfAnInterface(address);
  }

  /** Whether an address is one of them. Interfaces are read at each call: addresses change. */
  public boolean contains(InetAddress address) {
    if (!address.isLoopbackAddress()) {
      return isOfAnInterface(address);
    }
    return loopback == null || loopback.equals(address) || isDefault(address);
  }

  /** Whether it is the source address of unbound sockets: 127.0.0.1 and ::1. */
  private static boolean isDefault(InetAddress address) {
    byte[] bytes = address.getAddress();
    return bytes.length != IPV4_BYTES || (bytes[1] == 0 && bytes[2] == 0 && bytes[3] == 1);
  }

  /**
   * Whether an interface has the address. A link-local address means another computer on each link,
   * so it must be that of the interface on which the call arrived: on another link any computer may
   * have it.
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
