package org.dfra.report.fuzzy;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.dfra.behaviors.fuzzy.FuzzySystem;
import org.dfra.behaviors.fuzzy.Inference;
import org.dfra.behaviors.fuzzy.Variable;
import org.dfra.report.plot.Axis;
import org.dfra.report.plot.HeatPanel;
import org.dfra.report.plot.LinePanel;
import org.dfra.report.plot.Numerals;
import org.dfra.report.plot.Panel;
import org.dfra.report.plot.Series;

/**
 * An output over one or two inputs of a system, with the other inputs fixed.
 *
 * @param system evaluated as MATLAB does
 * @param inputs indices of the inputs along the axes: horizontal, then vertical if there is a
 *     second one
 * @param output index of the output
 * @param fixedInputs a value for each input of the system, each in its unit; those of the inputs
 *     along the axes are ignored
 */
record Surface(FuzzySystem system, List<Integer> inputs, int output, List<Double> fixedInputs) {

  private static final int ACROSS = 150;
  private static final int UP = 75;
  private static final String NO_RULE = "no rule fires";

  Surface {
    inputs = List.copyOf(inputs);
    fixedInputs = List.copyOf(fixedInputs);
  }

  /** The panel that shows it. */
  Panel panel() {
    return inputs.size() == 1 ? line() : heat();
  }

  private Variable shown() {
    return system.outputs().get(output);
  }

  private Variable along(int axis) {
    return system.inputs().get(inputs.get(axis));
  }

  /** {@code tr at right = 4, heading_error = 0}. */
  private String title() {
    return shown().name() + others();
  }

  /** {@code tr over left and centre at right = 4, heading_error = 0}. */
  String description() {
    String over =
        inputs.stream()
            .map(i -> system.inputs().get(i).name())
            .collect(Collectors.joining(" and "));
    return shown().name() + " over " + over + others();
  }

  private String others() {
    String others =
        IntStream.range(0, system.inputs().size())
            .filter(i -> !inputs.contains(i))
            .mapToObj(i -> system.inputs().get(i).name() + " = " + Numerals.of(fixedInputs.get(i)))
            .collect(Collectors.joining(", "));
    return others.isEmpty() ? "" : " at " + others;
  }

  /** The variable's range, or slightly longer if that is a single number. */
  static Axis axis(Variable variable) {
    double more = variable.low() == variable.high() ? 0.5 : 0;
    return Axis.of(variable.name(), "").between(variable.low() - more, variable.high() + more);
  }

  private HeatPanel heat() {
    double[][] cells = new double[UP][ACROSS];
    Inference inference = system.inference();
    for (int row = 0; row < UP; row++) {
      for (int column = 0; column < ACROSS; column++) {
        cells[row][column] =
            at(inference, value(along(0), column, ACROSS), value(along(1), row, UP));
      }
    }
    return new HeatPanel(title(), axis(along(0)), axis(along(1)), value(cells), cells)
        .whereMissing(NO_RULE);
  }

  /** Whether the middle of an output's range is 0, as of a yaw rate or a correction. */
  static boolean isAroundZero(Variable output) {
    return output.low() < 0 && output.low() == -output.high();
  }

  /** The range of the values, symmetric about zero if the output's range is. */
  private Axis value(double[][] cells) {
    Axis value = Axis.of(shown().name(), "");
    double most =
        Arrays.stream(cells)
            .flatMapToDouble(Arrays::stream)
            .filter(Double::isFinite)
            .map(Math::abs)
            .max()
            .orElse(0);
    return isAroundZero(shown()) && most > 0 ? value.between(-most, most) : value;
  }

  private LinePanel line() {
    Inference inference = system.inference();
    Axis axis = axis(along(0));
    double[] x =
        IntStream.rangeClosed(0, ACROSS)
            .mapToDouble(i -> axis.low() + (axis.high() - axis.low()) * i / ACROSS)
            .toArray();
    double[] y = IntStream.range(0, x.length).mapToDouble(i -> at(inference, x[i])).toArray();
    return new LinePanel(title(), axis, Axis.of(shown().name(), "")).add(Series.line("", x, y));
  }

  /** The centre of the n-th of equal parts of a variable's axis. */
  private static double value(Variable variable, int part, int parts) {
    Axis axis = axis(variable);
    return axis.low() + (part + 0.5) / parts * (axis.high() - axis.low());
  }

  /** The output; NaN if no rule for it fires. */
  private double at(Inference inference, double... along) {
    double[] values = fixedInputs.stream().mapToDouble(Double::doubleValue).toArray();
    for (int i = 0; i < along.length; i++) {
      values[inputs.get(i)] = along[i];
    }
    double[] outputs = new double[system.outputs().size()];
    inference.evaluate(values, outputs);
    double[] strengths = inference.strengths();
    boolean fires =
        IntStream.range(0, strengths.length)
            .anyMatch(
                i -> strengths[i] > 0 && system.rules().get(i).consequents().get(output) != 0);
    return fires ? outputs[output] : Double.NaN;
  }
}
