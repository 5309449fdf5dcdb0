package org.dfra.river.phoenix.access;

import java.net.InetAddress;
import java.rmi.AccessException;
import java.rmi.RemoteException;
import java.util.Optional;
import org.dfra.river.access.OwnAddresses;
import org.dfra.river.access.RemoteCaller;
import org.jspecify.annotations.Nullable;

/** Permits registration and monitoring only to callers on this machine. */
public final class LocalCallerGuard {

  private final OwnAddresses own = OwnAddresses.ofThisComputer();

  /**
   * Refuses the current remote call unless it came from an address of this machine. A caller in
   * this virtual machine is local.
   *
   * @param method the call, for the message
   */
  public void check(String method) throws RemoteException {
    Optional<RemoteCaller> caller = RemoteCaller.current();
    if (caller.isPresent() && !isLocal(caller.get())) {
      throw new AccessException(
          method
              + " is refused to "
              + caller.get()
              + ": only callers on phoenix's own machine may register and monitor");
    }
  }

  private boolean isLocal(RemoteCaller caller) {
    @Nullable InetAddress address = caller.address();
    return address != null && own.contains(address);
  }
}
