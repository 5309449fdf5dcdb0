package org.dfra.benchmarks;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.dfra.behaviors.fuzzy.FuzzySystem;
import org.dfra.behaviors.fuzzy.FuzzySystem.ToolboxCompatibility;
import org.dfra.behaviors.fuzzy.Inference;
import org.dfra.behaviors.fuzzy.LinearFunction;
import org.dfra.behaviors.fuzzy.Operators;
import org.dfra.behaviors.fuzzy.Variable;
import org.dfra.behaviors.fuzzy.Variable.Term;

/**
 * Measures time and allocations of the waypoint controller's 135 rules, as they are and as a Sugeno
 * system with the same rules, on inputs drawn uniformly from their ranges.
 */
final class FuzzyBench implements Bench {

  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
  private static final Path CONTROLLER =
      Path.of(System.getProperty("dfra.root", ".")).resolve("config/fuzzy/waypoint.fis");
  private static final int INPUTS = 1000;
  private static final int ROUNDS = 30;
  private static final int REPEATS = 40;
  private static final double MOST_MICROS = 5;
  private static final double NANOS_PER_MICRO = 1e3;

  @Override
  public void run(Report report) {
    FuzzySystem controller = FuzzySystem.read(CONTROLLER);
    report.say(
        controller.rules().size()
            + " rules of "
            + controller.inputs().size()
            + " inputs and "
            + controller.outputs().size()
            + " outputs, one evaluation:");
    measure(
        report, "Mamdani, centroid as MATLAB's", controller.inference(ToolboxCompatibility.MATLAB));
    measure(
        report, "Mamdani, centroid as Octave's", controller.inference(ToolboxCompatibility.OCTAVE));
    measure(report, "Sugeno", sugeno(controller).inference());
  }

  /** The same inputs and rules, with a constant instead of each consequent's set. */
  private static FuzzySystem sugeno(FuzzySystem system) {
    return new FuzzySystem(
        system.name() + " as Sugeno",
        FuzzySystem.Type.SUGENO,
        Operators.SUGENO,
        system.inputs(),
        system.outputs().stream().map(FuzzyBench::withConstants).toList(),
        system.rules());
  }

  /** Terms evenly spaced over the range. */
  private static Variable withConstants(Variable output) {
    List<Term> terms = new ArrayList<>();
    int count = output.terms().size();
    for (int i = 0; i < count; i++) {
      double value = output.low() + (i + 0.5) / count * (output.high() - output.low());
      terms.add(new Term(output.terms().get(i).name(), LinearFunction.constant(value)));
    }
    return new Variable(output.name(), output.low(), output.high(), terms);
  }

  private static void measure(Report report, String what, Inference inference) {
    double[][] inputs = inputs(inference.system());
    double[] outputs = new double[inference.system().outputs().size()];
    double[] micros = new double[ROUNDS];
    long[] bytes = new long[ROUNDS];
    double sum = 0;
    for (int round = 0; round < 2 * ROUNDS; round++) { // the first half warms up
      long allocated = THREADS.getCurrentThreadAllocatedBytes();
      long began = THREADS.getCurrentThreadCpuTime();
      for (int i = 0; i < REPEATS * INPUTS; i++) {
        inference.evaluate(inputs[i % INPUTS], outputs);
        sum += outputs[0];
      }
      long took = THREADS.getCurrentThreadCpuTime() - began;
      micros[round % ROUNDS] = took / NANOS_PER_MICRO / (REPEATS * INPUTS);
      bytes[round % ROUNDS] = THREADS.getCurrentThreadAllocatedBytes() - allocated;
    }
    if (!Double.isFinite(sum)) {
      throw new IllegalStateException(inference.system().name() + " gave no number somewhere");
    }
    report.figure(what + ", median", Report.quantile(micros, 0.5), MOST_MICROS, "µs");
    report.figure(what + ", slowest of " + ROUNDS + " rounds", Report.quantile(micros, 1), "µs");
    double perEvaluation = Arrays.stream(bytes).max().orElseThrow() / (REPEATS * (double) INPUTS);
    report.figure(what + ", allocated", perEvaluation, 0, "B");
  }

  private static double[][] inputs(FuzzySystem system) {
    Random random = new Random(135);
    double[][] all = new double[INPUTS][];
    Arrays.setAll(
        all,
        i ->
            system.inputs().stream()
                .mapToDouble(each -> each.low() + random.nextDouble() * (each.high() - each.low()))
                .toArray());
    return all;
  }
}
