package org.dfra.report.fuzzy;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dfra.behaviors.fuzzy.FuzzySystem;
import org.dfra.behaviors.fuzzy.LinearFunction;
import org.dfra.behaviors.fuzzy.MembershipFunction;
import org.dfra.behaviors.fuzzy.MembershipFunctionType;
import org.dfra.behaviors.fuzzy.RuleFormatter;
import org.dfra.behaviors.fuzzy.Variable;
import org.dfra.report.plot.Axis;
import org.dfra.report.plot.LinePanel;
import org.dfra.report.plot.Numerals;
import org.dfra.report.plot.Page;
import org.dfra.report.plot.Panel;
import org.dfra.report.plot.Series;
import org.dfra.report.plot.TextPanel;

/** A fuzzy system on one page: inputs, outputs, surfaces, and rules. */
final class SystemPage {

  /** Up to this number, rules are shown as sentences; more are clearer as a table. */
  private static final int MOST_SENTENCES = 24;

  private static final int MEMBERSHIP_HEIGHT = 220;
  private static final int SURFACE_HEIGHT = 360;
  private static final int SAMPLES = 200;
  private static final double STEP = 1e-9;

  private final FuzzySystem system;
  private final List<Surface> surfaces;

  SystemPage(FuzzySystem system, List<Surface> surfaces) {
    this.system = system;
    this.surfaces = List.copyOf(surfaces);
  }

  Page page() {
    Page page = new Page(title());
    rows(page, MEMBERSHIP_HEIGHT, system.inputs().stream().map(each -> sets("input", each)));
    if (system.type() == FuzzySystem.Type.MAMDANI) {
      rows(page, MEMBERSHIP_HEIGHT, system.outputs().stream().map(each -> sets("output", each)));
    } else {
      system.outputs().forEach(each -> addText(page, "output " + each.name(), functions(each)));
    }
    rows(page, SURFACE_HEIGHT, surfaces.stream().map(Surface::panel));
    addRules(page);
    return page;
  }

  private String title() {
    String kind = system.type() == FuzzySystem.Type.MAMDANI ? "Mamdani" : "Sugeno";
    int rules = system.rules().size();
    return system.name() + ": " + kind + ", " + rules + (rules == 1 ? " rule" : " rules");
  }

  /** Two panels in a row, or three if that avoids a gap. */
  private static void rows(Page page, int height, Stream<Panel> all) {
    List<Panel> panels = all.toList();
    int perRow = panels.size() % 2 == 1 && panels.size() % 3 == 0 ? 3 : 2;
    for (int i = 0; i < panels.size(); i += perRow) {
      List<Panel> row = panels.subList(i, Math.min(panels.size(), i + perRow));
      page.row(height, row.toArray(Panel[]::new));
    }
  }

  private static Panel sets(String role, Variable variable) {
    LinePanel panel =
        new LinePanel(
            role + " " + variable.name(),
            Surface.axis(variable),
            Axis.of("membership", "").between(0, 1.05));
    List<String> words = RuleFormatter.termLabels(variable);
    for (int term = 0; term < words.size(); term++) {
      MembershipFunction set = (MembershipFunction) variable.terms().get(term).function();
      double[] x = samples(variable, set);
      double[] y = Arrays.stream(x).map(set::at).toArray();
      panel.add(Series.line(words.get(term), x, y));
    }
    return panel;
  }

  /**
   * Sample points on both sides of each parameter, since corners and steps are there; evenly spaced
   * between.
   */
  private static double[] samples(Variable variable, MembershipFunction set) {
    Axis axis = Surface.axis(variable);
    double length = axis.high() - axis.low();
    boolean isStraight =
        set.type() == MembershipFunctionType.TRIMF || set.type() == MembershipFunctionType.TRAPMF;
    int parts = isStraight ? 1 : SAMPLES;
    return Stream.concat(
            IntStream.rangeClosed(0, parts).mapToObj(i -> axis.low() + length * i / parts),
            set.parameters().stream()
                .flatMap(each -> Stream.of(each - STEP * length, each, each + STEP * length)))
        .filter(x -> x >= axis.low() && x <= axis.high())
        .sorted()
        .mapToDouble(Double::doubleValue)
        .toArray();
  }

  private List<String> functions(Variable output) {
    List<String> words = RuleFormatter.termLabels(output);
    return IntStream.range(0, words.size())
        .mapToObj(
            i -> words.get(i) + " = " + formula((LinearFunction) output.terms().get(i).function()))
        .toList();
  }

  private String formula(LinearFunction function) {
    List<Double> parameters = function.parameters();
    StringBuilder formula = new StringBuilder();
    for (int i = 0; i < parameters.size() - 1; i++) {
      if (parameters.get(i) != 0) {
        append(formula, parameters.get(i));
        formula.append(" · ").append(system.inputs().get(i).name());
      }
    }
    double added = parameters.get(parameters.size() - 1);
    if (added != 0 || formula.isEmpty()) {
      append(formula, added);
    }
    return formula.toString();
  }

  private static void append(StringBuilder formula, double number) {
    if (formula.isEmpty()) {
      formula.append(Numerals.of(number));
    } else {
      formula.append(number < 0 ? " − " : " + ").append(Numerals.of(Math.abs(number)));
    }
  }

  private void addRules(Page page) {
    List<String> sentences = new RuleFormatter(system).numbered();
    if (sentences.size() > MOST_SENTENCES) {
      var table = RuleTable.of(system);
      if (table.isPresent()) {
        for (int output = 0; output < system.outputs().size(); output++) {
          var panel = table.get().panel(output);
          page.row(panel.height(), panel);
        }
        return;
      }
    }
    addText(page, "Rules", sentences);
  }

  private static void addText(Page page, String title, List<String> lines) {
    TextPanel text = new TextPanel(title, lines, lines.size() > 6 ? 2 : 1);
    page.row(text.height(Page.panelWidth(1)), text);
  }
}
