package org.dfra.behaviors.fuzzy;

import java.nio.file.Path;
import java.util.List;
import org.dfra.behaviors.fuzzy.Inference.MamdaniInference;
import org.dfra.behaviors.fuzzy.Inference.SugenoInference;
import org.dfra.behaviors.fuzzy.Variable.Term;

/**
 * A fuzzy inference system. Immutable; {@link #inference()} evaluates it.
 *
 * @param name its name
 * @param type Mamdani's or Sugeno's
 * @param operators inference operators
 * @param inputs at least one
 * @param outputs at least one
 * @param rules the rule base
 */
public record FuzzySystem(
    String name,
    Type type,
    Operators operators,
    List<Variable> inputs,
    List<Variable> outputs,
    List<FuzzySystem.Rule> rules) {

  /** Type of inference, by the consequents of its rules. */
  public enum Type {
    /** A fuzzy set. */
    MAMDANI,
    /** A constant or a weighted sum of the inputs. */
    SUGENO
  }

  /**
   * @throws IllegalArgumentException if its parts are inconsistent; the message names the cause
   */
  public FuzzySystem {
    inputs = List.copyOf(inputs);
    outputs = List.copyOf(outputs);
    rules = List.copyOf(rules);
    if (inputs.isEmpty() || outputs.isEmpty()) {
      throw new IllegalArgumentException(
          "the system " + name + " has no " + (inputs.isEmpty() ? "input" : "output"));
    }
    if (operators.defuzzification().isSugenoOnly() != (type == Type.SUGENO)) {
      throw new IllegalArgumentException(
          "the defuzzification "
              + Operators.fisName(operators.defuzzification())
              + " is not for a system of type "
              + Operators.fisName(type));
    }
    inputs.forEach(FuzzySystem::requireSets);
    for (Variable output : outputs) {
      if (type == Type.MAMDANI) {
        requireSets(output);
      } else {
        requireFunctions(output, inputs.size());
      }
    }
    for (int i = 0; i < rules.size(); i++) {
      requireRule(rules.get(i), i + 1, type, inputs, outputs);
    }
  }

  private static void requireSets(Variable variable) {
    for (Term term : variable.terms()) {
      if (!(term.function() instanceof MembershipFunction)) {
        throw new IllegalArgumentException(
            "the term "
                + term.name()
                + " of "
                + variable.name()
                + " is "
                + term.function().fisName()
                + ", which is allowed only in the outputs of a Sugeno system");
      }
    }
  }

  private static void requireFunctions(Variable output, int inputs) {
    for (Term term : output.terms()) {
      if (!(term.function() instanceof LinearFunction function)) {
        throw new IllegalArgumentException(
            "the term "
                + term.name()
                + " of "
                + output.name()
                + " is "
                + term.function().fisName()
                + "; an output of a Sugeno system must be constant or linear");
      }
      int wanted = function.isConstant() ? 1 : inputs + 1;
      if (function.parameters().size() != wanted) {
        throw new IllegalArgumentException(
            "the term "
                + term.name()
                + " of "
                + output.name()
                + " has "
                + function.parameters().size()
                + " parameters; linear takes one for each of the "
                + inputs
                + " inputs and a constant");
      }
    }
  }

  /**
   * Refuses a rule that names terms which its variables do not have.
   *
   * @param number its number in the rule base, from 1
   */
  static void requireRule(
      Rule rule, int number, Type type, List<Variable> inputs, List<Variable> outputs) {
    String where = "rule " + number;
    if (rule.antecedents().size() != inputs.size() || rule.consequents().size() != outputs.size()) {
      throw new IllegalArgumentException(
          where
              + " has terms of "
              + rule.antecedents().size()
              + " inputs and "
              + rule.consequents().size()
              + " outputs; the system has "
              + inputs.size()
              + " and "
              + outputs.size());
    }
    for (int i = 0; i < inputs.size(); i++) {
      requireTerm(where, rule.antecedents().get(i), inputs.get(i));
    }
    for (int i = 0; i < outputs.size(); i++) {
      requireTerm(where, rule.consequents().get(i), outputs.get(i));
      if (type == Type.SUGENO && rule.consequents().get(i) < 0) {
        throw new IllegalArgumentException(
            where + " has the complement of a function, which a Sugeno system does not allow");
      }
    }
  }

  private static void requireTerm(String where, int term, Variable variable) {
    if (Math.abs(term) > variable.terms().size()) {
      throw new IllegalArgumentException(
          where
              + " uses term "
              + Math.abs(term)
              + " of "
              + variable.name()
              + ", which has "
              + variable.terms().size()
              + " terms");
    }
  }

  /**
   * Reads a {@code .fis} file.
   *
   * @throws org.dfra.core.config.ConfigurationException naming file, line and word of the error
   */
  public static FuzzySystem read(Path file) {
    return FisReader.read(file);
  }

  /** Evaluates the system as MATLAB does. */
  public Inference inference() {
    return inference(ToolboxCompatibility.MATLAB);
  }

  /** Evaluates the system as one of the toolboxes does. */
  public Inference inference(ToolboxCompatibility engine) {
    return type == Type.MAMDANI
        ? new MamdaniInference(this, engine)
        : new SugenoInference(this, engine);
  }

  /**
   * A rule of a fuzzy system. Terms are numbered from 1; 0 means any, and a negative number the
   * complement (NOT) of a term.
   *
   * @param antecedents a term of each input
   * @param consequents a term of each output; 0 does not affect that output
   * @param weight weight of the rule, from 0 to 1
   * @param connective between the antecedents
   */
  public record Rule(
      List<Integer> antecedents, List<Integer> consequents, double weight, Connective connective) {

    /** Connective between antecedents. */
    public enum Connective {
      /** Conjunction. */
      AND,
      /** Disjunction. */
      OR
    }

    public Rule {
      antecedents = List.copyOf(antecedents);
      consequents = List.copyOf(consequents);
      if (!(weight >= 0 && weight <= 1)) {
        throw new IllegalArgumentException("the weight " + weight + " is not from 0 to 1");
      }
    }
  }

  /**
   * Selects the toolbox to follow where results differ: in the centroid, and where no rule fires.
   */
  public enum ToolboxCompatibility {
    /** Σμx / Σμ over the grid; the middle of the range where no rule fires. */
    MATLAB,
    /** ∫μx / ∫μ by the trapezoidal rule; NaN where no rule fires. */
    OCTAVE
  }
}
