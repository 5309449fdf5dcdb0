package org.dfra.flow.effector;

import org.dfra.lease.LeaseRefusedException;

/** Nobody can command the effector, since it is stopped for an emergency. */
public final class StoppedLeaseException extends LeaseRefusedException
    implements StoppedForEmergency {

  private static final long serialVersionUID = 1L;

  public StoppedLeaseException(String message) {
    super(message);
  }
}
