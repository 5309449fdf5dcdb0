package org.dfra.sim.world.noise;

import java.util.ArrayList;
import java.util.List;

/**
 * Spells that come and go, such as those in which a receiver hears no satellite: the time until the
 * next one and how long it lasts are both exponentially distributed. Confined to the world's
 * monitor.
 */
public final class Spells {

  /** Spells that are remembered for those who ask late. */
  private static final int REMEMBERED = 16;

  private record Spell(double from, double to) {}

  private final Draws draws;
  private final double between;
  private final double lasting;
  private final List<Spell> spells = new ArrayList<>();
  private long drawn;
  private double known;

  /**
   * @param perHour how many there are, not negative; none if 0
   * @param lasting how long one is on average, seconds, above 0
   */
  public Spells(Draws draws, double perHour, double lasting) {
    this.draws = draws;
    this.between = perHour > 0 ? Math.max(0, 3600 / perHour - lasting) : Double.POSITIVE_INFINITY;
    this.lasting = lasting;
  }

  /**
   * Whether there is one.
   *
   * @param seconds since the world began
   */
  public boolean isOn(double seconds) {
    while (known <= seconds && between < Double.POSITIVE_INFINITY) {
      double from = known + between * exponential();
      double to = from + lasting * exponential();
      spells.add(new Spell(from, to));
      known = to;
      if (spells.size() > REMEMBERED) {
        spells.remove(0);
      }
    }
    for (Spell spell : spells) {
      if (spell.from <= seconds && seconds < spell.to) {
        return true;
      }
    }
    return false;
  }

  private double exponential() {
    return -StrictMath.log(draws.uniform(drawn++));
  }
}
