package org.dfra.app.fuzzy;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.dfra.app.plot.Axis;
import org.dfra.app.plot.HeatPanel;
import org.dfra.app.plot.LinePanel;
import org.dfra.app.plot.Numerals;
import org.dfra.app.plot.Panel;
import org.dfra.app.plot.Series;
import org.dfra.behaviors.fuzzy.FuzzySystem;
import org.dfra.behaviors.fuzzy.Inference;
import org.dfra.behaviors.fuzzy.Variable;

/**
 * An output over two inputs of a system, or over the one that it has, while the others are held.
 *
 * @param system what is evaluated, as MATLAB does
 * @param inputs places of those along the axes: across, then upwards if there is a second one
 * @param output place of what is shown
 * @param fixedInputs a value for each input of the system, each in its unit; those along the axes
 *     do not count
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

  /** As long as the variable's range, or a little longer where that is but one number. */
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

  /** Whether an output has a middle of 0, as a turn rate or a correction. */
  static boolean isAroundZero(Variable output) {
    return output.low() < 0 && output.low() == -output.high();
  }

  /** As long as the values, but on both sides of zero where the output's range is. */
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

  /** The middle of so many-th of equal parts of a variable's axis. */
  private static double value(Variable variable, int part, int parts) {
    Axis axis = axis(variable);
    return axis.low() + (part + 0.5) / parts * (axis.high() - axis.low());
  }

  /** The output; not a number where no rule that says something of it fires. */
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
