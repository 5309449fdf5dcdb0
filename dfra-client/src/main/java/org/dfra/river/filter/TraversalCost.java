package org.dfra.river.filter;

/**
 * The cost of a walk through an object, as its hash code, a comparison and its text need it, in a
 * {@code long}: the visits, whether an object in it contains itself, and the depth of its nested
 * hash tables. A reference back counts like its target, so that visits grow as the walk does:
 * exponentially if an object refers to another several times.
 */
final class TraversalCost {

  private static final long MOST = 1L << 40;
  private static final int NESTING_BITS = 2;
  private static final long NESTING = (1L << NESTING_BITS) - 1;
  private static final long CYCLE = 1L << NESTING_BITS;
  private static final int VISITS_AT = NESTING_BITS + 1;

  /** The cost of an object without references. */
  static final long LEAF = of(1, 0);

  /**
   * The cost of a reference to an object that is not completely read: the object contains itself.
   */
  static final long CYCLIC = LEAF | CYCLE;

  private TraversalCost() {}

  static long of(long visits, long nesting) {
    return (Math.min(visits, MOST) << VISITS_AT) | Math.min(nesting, NESTING);
  }

  /** The same cost with another depth of nested hash tables. */
  static long nested(long cost, long nesting) {
    return of(visits(cost), nesting) | (cost & CYCLE);
  }

  /** Steps to compute a hash code; unlimited if an object contains itself. */
  static long steps(long cost) {
    return isCyclic(cost) ? MOST : visits(cost);
  }

  /** Objects that a walk visits, each once per reference; one round of each cycle. */
  static long visits(long cost) {
    return cost >>> VISITS_AT;
  }

  /** Whether an object in it contains itself. */
  static boolean isCyclic(long cost) {
    return (cost & CYCLE) != 0;
  }

  static long nesting(long cost) {
    return cost & NESTING;
  }

  /** The cost of an object that refers to both. */
  static long sum(long one, long other) {
    return of(visits(one) + visits(other), Math.max(nesting(one), nesting(other)))
        | ((one | other) & CYCLE);
  }
}
