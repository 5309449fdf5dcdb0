package org.dfra.lease;

/** What the holder of a lease is to the module. */
public enum LeaseRole {
  /** Makes the module work. */
  CLIENT,
  /** Makes an effector work, and tells it what to do; there is one at most. */
  COMMANDER,
  /** Watches it, whether it works or not. */
  OBSERVER;

  /** Whether a module with such a holder has to work. */
  public boolean isClient() {
    return this != OBSERVER;
  }
}
