package org.dfra.sim.world.noise;

import java.util.ArrayList;
import java.util.List;

/**
 * Random outages, such as those in which a receiver tracks no satellite: the time until the next
 * one and its duration are both exponentially distributed. Confined to the world's monitor.
 */
public final class OutageProcess {

  /** Number of outages stored for late queries. */
  private static final int REMEMBERED = 16;

  private record Outage(double from, double to) {}

  private final RandomStream draws;
  private final double between;
  private final double lasting;
  private final List<Outage> spells = new ArrayList<>();
  private long drawn;
  private double known;

  /**
   * @param perHour mean number per hour, not negative; none if 0
   * @param lasting mean duration, seconds, above 0
   */
  public OutageProcess(RandomStream draws, double perHour, double lasting) {
    this.draws = draws;
    this.between = perHour > 0 ? Math.max(0, 3600 / perHour - lasting) : Double.POSITIVE_INFINITY;
    this.lasting = lasting;
  }

  /**
   * Whether there is an outage at this time.
   *
   * @param seconds since the start of the world
   */
  public boolean isActive(double seconds) {
    while (known <= seconds && between < Double.POSITIVE_INFINITY) {
      double from = known + between * exponential();
      double to = from + lasting * exponential();
      spells.add(new Outage(from, to));
      known = to;
      if (spells.size() > REMEMBERED) {
        spells.remove(0);
      }
    }
    for (Outage spell : spells) {
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
