package org.dfra.lease;

/** What the holder of a lease is to the module. */
public enum Holder {
  /** Makes the module work. */
  CLIENT,
  /** Watches it, whether it works or not. */
  WATCHER
}
