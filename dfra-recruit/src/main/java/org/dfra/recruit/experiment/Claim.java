package org.dfra.recruit.experiment;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * How the affective strategy compares with another in a cell, by one metric. Only a sign is
 * claimed, and only where the interval of the paired difference has one.
 *
 * @param cell the affective one
 * @param rival the other strategy
 * @param more how much more there is with the affective strategy; below 0 it is better
 * @param share the same as a share of what the rival has; NaN where that is nothing
 */
public record Claim(Metric metric, Cell cell, String rival, Estimate more, double share) {

  /** What is compared with all others. */
  public static final String AFFECTIVE = "affective";

  /** What the intervals allow to say. */
  public enum Verdict {
    WINS,
    LOSES,
    /** The interval holds 0: no difference was seen. */
    OPEN
  }

  /** Whether the affective strategy is better. */
  public Verdict verdict() {
    if (more.high() < 0) {
      return Verdict.WINS;
    }
    return more.low() > 0 ? Verdict.LOSES : Verdict.OPEN;
  }

  /** Every comparison there is, in the order of the cells. */
  public static List<Claim> all(List<CellResult> results) {
    Map<Cell, CellResult> byCell = new HashMap<>();
    results.forEach(result -> byCell.put(result.cell(), result));
    List<Claim> claims = new ArrayList<>();
    for (CellResult result : results) {
      if (!result.cell().strategy().equals(AFFECTIVE)) {
        continue;
      }
      for (String rival : Grid.strategies(results)) {
        CellResult other = byCell.get(result.cell().with(rival));
        if (!rival.equals(AFFECTIVE) && other != null) {
          for (Metric metric : Metric.values()) {
            claims.add(of(metric, result, other));
          }
        }
      }
    }
    return claims;
  }

  private static Claim of(Metric metric, CellResult affective, CellResult other) {
    Estimate more = metric.more(affective, other);
    double there = metric.of(other).value();
    return new Claim(
        metric,
        affective.cell(),
        other.cell().strategy(),
        more,
        there == 0 ? Double.NaN : more.value() / there);
  }

  /** {@code affective, broadcast, 6 vehicles, 10 % loss: less transmissions than greedy: …}. */
  @Override
  public String toString() {
    String verb =
        switch (verdict()) {
          case WINS -> "less than " + rival;
          case LOSES -> "more than " + rival;
          case OPEN -> "no difference to " + rival + " was seen";
        };
    return String.format(Locale.ROOT, "%s: %s, %s: %s", cell, metric.title(), verb, more);
  }
}
