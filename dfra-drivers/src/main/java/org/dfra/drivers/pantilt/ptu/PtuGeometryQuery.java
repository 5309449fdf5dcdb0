package org.dfra.drivers.pantilt.ptu;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dfra.drivers.pantilt.ptu.PtuCommands.PtuAxis;
import org.dfra.drivers.pantilt.ptu.PtuReply.Refused;
import org.dfra.drivers.pantilt.ptu.PtuReply.Value;
import org.dfra.persona.PanTiltAttributes;
import org.jspecify.annotations.Nullable;

/**
 * The queries that must be answered before the unit can be used, and the answers. Confined to one
 * thread.
 */
final class PtuGeometryQuery {

  private static final List<String> ASKED =
      List.of("PR", "TR", "PN", "PX", "TN", "TX", "PL", "PU", "TL", "TU");

  private final Map<String, Double> answers = new LinkedHashMap<>();
  private @Nullable PtuGeometry geometry;

  /** The next query; only while there is no {@link #geometry}. */
  String nextQuestion() {
    return ASKED.get(answers.size());
  }

  /** Accepts the answer to the {@link #nextQuestion}; returns what is wrong with it, or empty. */
  String accept(String question, PtuReply reply) {
    if (reply instanceof Refused refused) {
      return "it refuses the query " + question + ": " + refused.message();
    }
    if (!(reply instanceof Value value) || value.number().isEmpty()) {
      return "its answer to " + question + " is not a number: " + reply;
    }
    answers.put(question, value.number().getAsDouble());
    if (answers.size() < ASKED.size()) {
      return "";
    }
    try {
      geometry = new PtuGeometry(limits(PtuAxis.PAN), limits(PtuAxis.TILT));
      return "";
    } catch (IllegalArgumentException e) {
      return "its answer is impossible: " + e.getMessage();
    }
  }

  /** The reported limits; null until they are complete. */
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
    return answers.getOrDefault("" + axis.letter() + what, Double.NaN);
  }

  /**
   * The limits of the two axes, as reported by the unit.
   *
   * @param pan to the left is +
   * @param tilt up is +
   */
  record PtuGeometry(PtuAxisLimits pan, PtuAxisLimits tilt) {

    /** The attributes for discovery; the speed is that of the slower axis. */
    public PanTiltAttributes attributes() {
      return new PanTiltAttributes(
          pan.minAngle(),
          pan.maxAngle(),
          tilt.minAngle(),
          tilt.maxAngle(),
          Math.min(pan.fastestSpeed(), tilt.fastestSpeed()));
    }
  }
}
