package org.dfra.river.proxy;

import java.rmi.Remote;
import java.rmi.RemoteException;
import net.jini.core.constraint.MethodConstraints;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.core.lease.Lease;
import org.dfra.river.remote.ProcessLease;
import org.jspecify.annotations.Nullable;

/**
 * Prepares what a module's answers contain, before the first call of it: it gets the constraints of
 * the proxy that returned it, so that only the same robot's processes answer. Without constraints,
 * in the open mode, it is returned unchanged.
 */
final class PreparedProxies {

  private PreparedProxies() {}

  private static @Nullable MethodConstraints constraints(Remote server) {
    return server instanceof RemoteMethodControl control ? control.getConstraints() : null;
  }

  /**
   * A lease.
   *
   * @param server the module's remote proxy
   * @throws RemoteException if it is a lease of another kind than modules grant, so that nobody can
   *     say who renews it
   */
  static Lease lease(Remote server, Lease granted) throws RemoteException {
    @Nullable MethodConstraints constraints = constraints(server);
    if (constraints == null) {
      return granted;
    } else if (granted instanceof ProcessLease lease) {
      return lease.constrained(constraints);
    }
    return (Lease) constrained(granted, constraints);
  }

  /**
   * The proxy of an object beside the module, such as its administration.
   *
   * @param server the module's remote proxy
   * @throws RemoteException if nobody can authenticate its server
   */
  static Object proxy(Remote server, Object returned) throws RemoteException {
    @Nullable MethodConstraints constraints = constraints(server);
    return constraints == null ? returned : constrained(returned, constraints);
  }

  private static Object constrained(Object returned, MethodConstraints constraints)
      throws RemoteException {
    if (returned instanceof RemoteMethodControl control) {
      return control.setConstraints(constraints);
    }
    throw new RemoteException(
        "an answer with a "
            + returned.getClass().getName()
            + ", whose server nobody can authenticate");
  }
}
