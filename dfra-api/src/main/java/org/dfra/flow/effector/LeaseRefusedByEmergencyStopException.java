package org.dfra.flow.effector;

import org.dfra.lease.LeaseRefusedException;

/** A command lease was refused, since the effector is in an emergency stop. */
public final class LeaseRefusedByEmergencyStopException extends LeaseRefusedException
    implements RefusedByEmergencyStop {

  private static final long serialVersionUID = 1L;

  public LeaseRefusedByEmergencyStopException(String message) {
    super(message);
  }
}
