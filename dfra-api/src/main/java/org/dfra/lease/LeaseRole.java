package org.dfra.lease;

/** The role of a lease's holder towards the module. */
public enum LeaseRole {
  /** Uses the module, which must therefore work. */
  CLIENT,
  /** Uses and commands an effector; there is at most one. */
  COMMANDER,
  /** Observes the module, whether it works or not. */
  OBSERVER;

  /** Whether a module with such a holder has to work. */
  public boolean isClient() {
    return this != OBSERVER;
  }
}
