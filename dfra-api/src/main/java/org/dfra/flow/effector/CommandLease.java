package org.dfra.flow.effector;

import org.dfra.lease.ModuleLease;

/**
 * The right to command an effector, held by one at a time. It renews itself until it is closed, but
 * never comes back once it is lost: who has lost it looks at the world again before the next
 * command.
 */
public interface CommandLease extends ModuleLease {

  /** What the holder's commands are accompanied by. */
  CommandKey key();
}
