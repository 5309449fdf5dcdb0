package org.dfra.river.transport;

import java.net.InetAddress;
import org.jspecify.annotations.Nullable;

/**
 * The process at the other end of a connection, as far as the operating system tells.
 *
 * @param address the address it connected from; for a Unix-domain socket the one that both sides
 *     call this computer
 * @param user name of the user that runs it; null if it is connected by TCP
 */
record Peer(InetAddress address, @Nullable String user) {

  /** Whose share of this virtual machine its calls use: the own user's, or that of the address. */
  Object origin() {
    return user == null ? address : user;
  }

  /** Whether it is a process of this computer that the operating system has identified. */
  boolean isLocalUser() {
    return user != null;
  }

  @Override
  public String toString() {
    return user == null ? address.getHostAddress() : "a local process of " + user;
  }
}
