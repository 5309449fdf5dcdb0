package org.dfra.flow.effector;

import org.dfra.lease.LeaseRefusedException;

/** Nobody can command the effector, since it is stopped for an emergency. */
public final class LeaseRefusedByEmergencyStopException extends LeaseRefusedException
    implements RefusedByEmergencyStop {

  private static final long serialVersionUID = 1L;

  public LeaseRefusedByEmergencyStopException(String message) {
    super(message);
  }
}
