package org.dfra.river.filter;

/**
 * What it costs to walk through an object, as its hash code, a comparison and its text do, in a
 * {@code long}: the visits, whether something in it contains itself, and how many hash tables are
 * in one another in it. A reference back counts as what it refers to, so that visits grow as the
 * walk does, by powers where an object refers to another several times.
 */
final class TraversalCost {

  private static final long MOST = 1L << 40;
  private static final int NESTING_BITS = 2;
  private static final long NESTING = (1L << NESTING_BITS) - 1;
  private static final long CYCLE = 1L << NESTING_BITS;
  private static final int VISITS_AT = NESTING_BITS + 1;

  /** Of what refers to nothing. */
  static final long LEAF = of(1, 0);

  /** Of a reference to what is not read to its end: it contains itself. */
  static final long CYCLIC = LEAF | CYCLE;

  private TraversalCost() {}

  static long of(long visits, long nesting) {
    return (Math.min(visits, MOST) << VISITS_AT) | Math.min(nesting, NESTING);
  }

  /** The same with another number of hash tables in one another. */
  static long nested(long cost, long nesting) {
    return of(visits(cost), nesting) | (cost & CYCLE);
  }

  /** Steps to compute a hash code, which never ends where something contains itself. */
  static long steps(long cost) {
    return isCyclic(cost) ? MOST : visits(cost);
  }

  /** Objects that a walk visits, each as often as it is referred to; one round of each cycle. */
  static long visits(long cost) {
    return cost >>> VISITS_AT;
  }

  /** Whether something in it contains itself. */
  static boolean isCyclic(long cost) {
    return (cost & CYCLE) != 0;
  }

  static long nesting(long cost) {
    return cost & NESTING;
  }

  /** Of an object that refers to both. */
  static long sum(long one, long other) {
    return of(visits(one) + visits(other), Math.max(nesting(one), nesting(other)))
        | ((one | other) & CYCLE);
  }
}
