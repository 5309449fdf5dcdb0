package org.dfra.behaviors.motor;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dfra.behaviors.fuzzy.FuzzySystem;
import org.dfra.behaviors.fuzzy.Inference;
import org.dfra.behaviors.fuzzy.RuleFormatter;
import org.dfra.behaviors.fuzzy.Variable;
import org.dfra.core.config.ConfigurationException;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.perceptual.HeadingPercept;

/**
 * A fuzzy controller that drives to a waypoint: it finds its inputs and outputs by name, in any
 * order. Confined to one thread.
 *
 * <p>Inputs {@code left}, {@code centre}, {@code right}: clearance in metres; {@code
 * heading_error}: degrees, to the left is +. Outputs {@code tr}: forward speed as a fraction of the
 * maximum, limited to 0 to 1; {@code rv}: yaw rate as a fraction of the maximum, between −1 and 1,
 * to the left is +.
 */
final class WaypointController {

  private static final List<String> INPUTS = List.of("left", "centre", "right", "heading_error");
  private static final List<String> OUTPUTS = List.of("tr", "rv");

  private final Inference inference;
  private final String method;
  private final List<String> sentences;
  private final int[] inputs; // index in the file's order
  private final int[] outputs;
  private final double[] in;
  private final double[] out;

  /**
   * The controller's output.
   *
   * @param speedFraction as a fraction of the maximum, 0 to 1
   * @param yawRateFraction as a fraction of the maximum, −1 to 1
   * @param reason the rule that fires strongest
   * @param strength its firing strength, 0 to 1
   */
  record ControlOutput(
      double speedFraction, double yawRateFraction, String reason, double strength) {}

  /**
   * Reads the system.
   *
   * @throws ConfigurationException if the file is not a fuzzy system, or lacks a variable; the
   *     message names it
   */
  WaypointController(Path file) {
    FuzzySystem system = FuzzySystem.read(file);
    this.inputs = indices(file, "inputs", INPUTS, system.inputs());
    this.outputs = indices(file, "outputs", OUTPUTS, system.outputs());
    this.method = system.type().name().toLowerCase(Locale.ROOT);
    this.inference = system.inference();
    this.sentences = new RuleFormatter(system).all();
    this.in = new double[inputs.length];
    this.out = new double[outputs.length];
  }

  private static int[] indices(
      Path file, String what, List<String> wanted, List<Variable> variables) {
    List<String> names = variables.stream().map(Variable::name).toList();
    List<String> missing = new ArrayList<>(wanted);
    missing.removeAll(names);
    List<String> others = new ArrayList<>(names);
    others.removeAll(wanted);
    if (!missing.isEmpty() || !others.isEmpty() || names.size() != wanted.size()) {
      throw new ConfigurationException(
          file
              + ": a waypoint controller needs the "
              + what
              + " "
              + String.join(", ", wanted)
              + ", each once; this system has "
              + String.join(", ", names)
              + (missing.isEmpty() ? "" : ": add " + String.join(", ", missing))
              + (others.isEmpty() ? "" : ": remove or rename " + String.join(", ", others)));
    }
    return wanted.stream().mapToInt(names::indexOf).toArray();
  }

  /** Its type of inference: {@code mamdani} or {@code sugeno}. */
  String inferenceType() {
    return method;
  }

  /** Number of rules. */
  int ruleCount() {
    return sentences.size();
  }

  ControlOutput evaluate(Clearance clearance, HeadingPercept heading) {
    in[inputs[0]] = clearance.left();
    in[inputs[1]] = clearance.centre();
    in[inputs[2]] = clearance.right();
    in[inputs[3]] = Math.toDegrees(heading.headingError());
    inference.evaluate(in, out);
    double[] strengths = inference.strengths();
    int strongest = 0;
    for (int i = 1; i < strengths.length; i++) {
      strongest = strengths[i] > strengths[strongest] ? i : strongest;
    }
    boolean any = strengths.length > 0 && strengths[strongest] > 0;
    return new ControlOutput(
        Math.max(0, Math.min(1, out[outputs[0]])),
        Math.max(-1, Math.min(1, out[outputs[1]])),
        any ? sentences.get(strongest) : "no rule applies",
        any ? Math.min(1, strengths[strongest]) : 0);
  }
}
