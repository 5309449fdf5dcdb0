package org.dfra.river.transport;

import net.jini.core.constraint.InvocationConstraints;
import net.jini.io.UnsupportedConstraintException;
import net.jini.jeri.ServerEndpoint;
import net.jini.jeri.tcp.TcpServerEndpoint;

/** The constraints that an unencrypted connection meets: those that River's own TCP meets. */
final class TransportConstraints {

  private static final ServerEndpoint TCP = TcpServerEndpoint.getInstance("127.0.0.1", 0);

  private TransportConstraints() {}

  /**
   * Checks them.
   *
   * @return those that remain for the layers above
   * @throws UnsupportedConstraintException if a required one cannot be met
   */
  static InvocationConstraints check(InvocationConstraints constraints)
      throws UnsupportedConstraintException {
    return constraints.isEmpty() ? constraints : TCP.checkConstraints(constraints);
  }
}
