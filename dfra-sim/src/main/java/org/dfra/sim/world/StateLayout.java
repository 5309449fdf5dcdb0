package org.dfra.sim.world;

/** Allocates the columns in a row of the history. */
final class StateLayout {

  private int taken;

  /** Allocates adjacent columns to the caller; returns the first. */
  int allocate(int count) {
    int first = taken;
    taken += count;
    return first;
  }

  /** Number of allocated columns. */
  int columns() {
    return taken;
  }
}
