package org.dfra.river.proxy;

import java.rmi.Remote;
import java.rmi.RemoteException;
import net.jini.core.constraint.MethodConstraints;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.core.lease.Lease;
import org.dfra.river.remote.ProcessLease;
import org.jspecify.annotations.Nullable;

/** Prepares the leases that modules grant, before the first call of their landlords. */
public final class ReceivedLease {

  private ReceivedLease() {}

  /**
   * A lease with the constraints of the proxy that returned it. Without constraints, in the open
   * mode, it is returned unchanged.
   *
   * @param server the module's remote proxy
   * @throws RemoteException if it is a lease of another kind than modules grant, so that nobody can
   *     say who renews it
   */
  public static Lease from(Remote server, Lease granted) throws RemoteException {
    @Nullable MethodConstraints constraints =
        server instanceof RemoteMethodControl control ? control.getConstraints() : null;
    if (constraints == null) {
      return granted;
    } else if (granted instanceof ProcessLease lease) {
      return lease.constrained(constraints);
    } else if (granted instanceof RemoteMethodControl control) {
      return (Lease) control.setConstraints(constraints);
    }
    throw new RemoteException(
        "a lease of " + granted.getClass().getName() + ", whose grantor nobody can authenticate");
  }
}
