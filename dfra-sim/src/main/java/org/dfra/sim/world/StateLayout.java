package org.dfra.sim.world;

/** Gives out the places in a row of the history. */
final class StateLayout {

  private int taken;

  /** The first of so many places in a row that are the caller's from now on. */
  int allocate(int count) {
    int first = taken;
    taken += count;
    return first;
  }

  /** How many were taken. */
  int columns() {
    return taken;
  }
}
