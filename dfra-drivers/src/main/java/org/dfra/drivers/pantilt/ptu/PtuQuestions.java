package org.dfra.drivers.pantilt.ptu;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dfra.drivers.pantilt.ptu.PtuReply.Refused;
import org.dfra.drivers.pantilt.ptu.PtuReply.Value;
import org.jspecify.annotations.Nullable;

/** What the unit is asked before it can be used, and what it said. Confined to one thread. */
final class PtuQuestions {

  private static final List<String> ASKED =
      List.of("PR", "TR", "PN", "PX", "TN", "TX", "PL", "PU", "TL", "TU");

  private final Map<String, Double> told = new LinkedHashMap<>();
  private @Nullable PtuGeometry geometry;

  /** The next question; only while there is no {@link #geometry}. */
  String next() {
    return ASKED.get(told.size());
  }

  /** Takes the answer to the {@link #next} question; what is wrong with it, or empty. */
  String take(String question, PtuReply reply) {
    if (reply instanceof Refused refused) {
      return "it refuses to tell " + question + ": " + refused.message();
    }
    if (!(reply instanceof Value value) || value.number().isEmpty()) {
      return "its answer to " + question + " is no number: " + reply;
    }
    told.put(question, value.number().getAsDouble());
    if (told.size() < ASKED.size()) {
      return "";
    }
    try {
      geometry = new PtuGeometry(limits(PtuAxis.PAN), limits(PtuAxis.TILT));
      return "";
    } catch (IllegalArgumentException e) {
      return "it tells what cannot be: " + e.getMessage();
    }
  }

  /** What it said; null until it has said all. */
  @Nullable PtuGeometry geometry() {
    return geometry;
  }

  private PtuAxisLimits limits(PtuAxis axis) {
    return new PtuAxisLimits(
        axis,
        number(axis, 'R'),
        (int) number(axis, 'N'),
        (int) number(axis, 'X'),
        (int) number(axis, 'L'),
        (int) number(axis, 'U'));
  }

  private double number(PtuAxis axis, char what) {
    return told.getOrDefault("" + axis.letter() + what, Double.NaN);
  }
}
