package org.dfra.river.filter;

/**
 * What it costs to compute the hash code of an object, in a {@code long}: the steps, and how many
 * hash tables are in one another in it. A reference back counts as what it refers to, so that steps
 * grow as the computation does, by powers where an object refers to another several times.
 */
final class Cost {

  private static final long MOST = 1L << 40;
  private static final int NESTING_BITS = 2;
  private static final long NESTING = (1L << NESTING_BITS) - 1;

  /** Of what refers to nothing. */
  static final long LEAF = of(1, 0);

  /** Of what is not read to its end: it contains the reference to itself. */
  static final long ENDLESS = of(MOST, 0);

  private Cost() {}

  static long of(long steps, long nesting) {
    return (Math.min(steps, MOST) << NESTING_BITS) | Math.min(nesting, NESTING);
  }

  static long steps(long cost) {
    return cost >>> NESTING_BITS;
  }

  static long nesting(long cost) {
    return cost & NESTING;
  }

  /** Of an object that refers to both. */
  static long sum(long one, long other) {
    return of(steps(one) + steps(other), Math.max(nesting(one), nesting(other)));
  }
}
