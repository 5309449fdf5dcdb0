package org.dfra.river.remote;

import net.jini.core.lease.LeaseDeniedException;

/** An administrator has revoked the lease; its holder must not request it again. */
public final class LeaseRevokedException extends LeaseDeniedException {

  private static final long serialVersionUID = 1L;

  public LeaseRevokedException(String message) {
    super(message);
  }
}
