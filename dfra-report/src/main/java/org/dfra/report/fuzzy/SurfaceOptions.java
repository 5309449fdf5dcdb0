package org.dfra.report.fuzzy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dfra.behaviors.fuzzy.FuzzySystem;
import org.dfra.behaviors.fuzzy.Variable;
import org.dfra.core.config.NearestName;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;

/** Parses the options that select surfaces of a system. */
final class SurfaceOptions {

  private final FuzzySystem system;

  SurfaceOptions(FuzzySystem system) {
    this.system = system;
  }

  /**
   * The surfaces.
   *
   * @param surfaces {@code IN1,IN2} or {@code IN1,IN2,OUT} each; if there are none, each output
   *     over the first two inputs
   * @param held {@code NAME=VALUE} each
   * @throws CommandFailure if one of them does not match the system
   */
  List<Surface> surfaces(List<String> surfaces, List<String> held) {
    List<Double> values = fixedInputs(held);
    List<Surface> all =
        surfaces.isEmpty()
            ? each(IntStream.range(0, Math.min(2, system.inputs().size())).boxed().toList(), values)
            : surfaces.stream().flatMap(each -> surface(each, values)).toList();
    for (String each : held) {
      String name = each.substring(0, each.indexOf('='));
      int input = place(name, system.inputs(), "input");
      if (all.stream().allMatch(surface -> surface.inputs().contains(input))) {
        throw wrong("--at=" + each + ": " + name + " is along an axis, so it is not held");
      }
    }
    return all;
  }

  private List<Surface> each(List<Integer> inputs, List<Double> values) {
    return IntStream.range(0, system.outputs().size())
        .mapToObj(output -> new Surface(system, inputs, output, values))
        .toList();
  }

  private Stream<Surface> surface(String written, List<Double> values) {
    List<String> names = Arrays.stream(written.split(",", -1)).map(String::strip).toList();
    if (names.size() < 2 || names.size() > 3) {
      throw wrong(
          "--surface="
              + written
              + " names "
              + names.size()
              + "; write two inputs, and an output if only one is wanted: IN1,IN2[,OUT]");
    }
    List<Integer> inputs =
        names.subList(0, 2).stream().map(name -> place(name, system.inputs(), "input")).toList();
    if (inputs.get(0).equals(inputs.get(1))) {
      throw wrong("--surface=" + written + " names one input twice; name two");
    }
    return names.size() == 2
        ? each(inputs, values).stream()
        : Stream.of(
            new Surface(system, inputs, place(names.get(2), system.outputs(), "output"), values));
  }

  /** A value for each input: the option's, or the middle of its range. */
  private List<Double> fixedInputs(List<String> written) {
    List<Double> values = new ArrayList<>(system.inputs().stream().map(Variable::middle).toList());
    for (String each : written) {
      int sign = each.indexOf('=');
      if (sign < 0) {
        throw wrong("--at=" + each + " is not NAME=VALUE, as in --at=" + example() + "=0");
      }
      int input = place(each.substring(0, sign), system.inputs(), "input");
      values.set(input, number(each, each.substring(sign + 1)));
    }
    return values;
  }

  private String example() {
    return system.inputs().get(0).name();
  }

  private static double number(String option, String text) {
    try {
      double value = Double.parseDouble(text);
      if (Double.isFinite(value)) {
        return value;
      }
    } catch (NumberFormatException e) {
      throw wrong("--at=" + option + ": \"" + text + "\" is not a number");
    }
    throw wrong("--at=" + option + ": \"" + text + "\" is not finite");
  }

  private int place(String name, List<Variable> variables, String kind) {
    List<String> names = variables.stream().map(Variable::name).toList();
    int place = names.indexOf(name.strip());
    if (place < 0) {
      String there = "; there is " + String.join(", ", names);
      throw wrong(
          system.name()
              + " has no "
              + kind
              + " \""
              + name.strip()
              + "\""
              + NearestName.hint(name.strip(), names, there));
    }
    return place;
  }

  private static CommandFailure wrong(String sentence) {
    return new CommandFailure(ExitCode.USAGE_ERROR, sentence);
  }
}
