package org.dfra.flow.effector;

import org.dfra.lease.ModuleLease;

/**
 * The right to command an effector, held by one client at a time. It renews itself until it is
 * closed. A lost lease is never re-acquired automatically: the client must check the state of the
 * world before it requests a new one.
 */
public interface CommandLease extends ModuleLease {

  /** The key that each of the holder's commands must carry. */
  CommandKey key();
}
