package org.dfra.river.phoenix;

import java.net.InetAddress;
import java.rmi.RemoteException;
import java.rmi.server.ServerNotActiveException;
import net.jini.export.ServerContext;
import net.jini.io.context.ClientHost;
import org.dfra.river.access.OwnAddresses;
import org.jspecify.annotations.Nullable;

/** Lets only callers on this machine register and monitor. */
final class LocalAccess {

  /**
   * Refuses the remote call under way unless it came from an address of this machine. A caller in
   * this virtual machine is local.
   *
   * @param what the call, for the message
   */
  void check(String what) throws RemoteException {
    InetAddress caller = caller();
    if (caller != null && !OwnAddresses.ofThisComputer().contain(caller)) {
      throw new java.rmi.AccessException(
          what
              + " is refused to "
              + caller.getHostAddress()
              + ": only callers on phoenix's own machine may register and monitor");
    }
  }

  private static @Nullable InetAddress caller() {
    try {
      return ServerContext.getServerContextElement(ClientHost.class) instanceof ClientHost host
          ? host.getClientHost()
          : null;
    } catch (ServerNotActiveException e) {
      return null; // no remote call: a caller in this virtual machine
    }
  }
}
