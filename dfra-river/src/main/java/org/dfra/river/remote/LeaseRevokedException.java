package org.dfra.river.remote;

import net.jini.core.lease.LeaseDeniedException;

/** An administrator has ended the lease that was to be renewed; its holder does not come back. */
public final class LeaseRevokedException extends LeaseDeniedException {

  private static final long serialVersionUID = 1L;

  public LeaseRevokedException(String message) {
    super(message);
  }
}
