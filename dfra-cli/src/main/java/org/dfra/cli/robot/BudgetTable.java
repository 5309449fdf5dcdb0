package org.dfra.cli.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dfra.core.budget.Budget;
import org.dfra.core.budget.BudgetLimits;
import org.dfra.core.budget.BudgetUse;
import org.dfra.core.budget.ListenerPriority;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.Table;
import org.dfra.river.bootstrap.BudgetSurvey;
import org.dfra.river.security.budget.BudgetMonitor.RadioUse;
import org.jspecify.annotations.Nullable;

/** Prints what the processes of this computer's robots report about their budgets. */
final class BudgetTable {

  private static final double MILLIS_PER_SECOND = 1000;
  private static final double KILO = 1000;

  private BudgetTable() {}

  /**
   * A row, also of the JSON. Limits that do not exist are null. Rates are means over 10 s.
   *
   * @param per caller or object
   * @param bytes per second
   * @param calls per second
   * @param processorMillis per second
   */
  record Row(
      String group,
      String budget,
      String per,
      String owner,
      double bytes,
      @Nullable Double maxBytes,
      double calls,
      @Nullable Double maxCalls,
      double processorMillis,
      @Nullable Double maxProcessorMillis,
      int listeners,
      @Nullable Double maxListeners,
      long refused,
      long slowed,
      long thinned) {

    static Row of(String group, BudgetUse use) {
      BudgetLimits limits = use.limits();
      return new Row(
          group,
          use.budget(),
          use.scope().name().toLowerCase(Locale.ROOT),
          use.owner(),
          use.bytes(),
          finite(limits.bytes(), 1),
          use.calls(),
          finite(limits.calls(), 1),
          use.processorTime() * MILLIS_PER_SECOND,
          finite(limits.processorTime(), MILLIS_PER_SECOND),
          use.listeners(),
          finite(limits.listeners(), 1),
          use.refused(),
          use.slowed(),
          use.thinned());
    }

    private static @Nullable Double finite(double limit, double factor) {
      return limit == BudgetLimits.UNLIMITED ? null : limit * factor;
    }
  }

  /** Prints the accounts, then the radio, then what did not answer. */
  static void show(CommandOutput answer, BudgetSurvey survey) {
    List<Row> rows = new ArrayList<>();
    survey
        .reports()
        .forEach(
            (group, report) -> report.accounts().forEach(each -> rows.add(Row.of(group, each))));
    Table table =
        new Table(
            "GROUP",
            "BUDGET",
            "USED BY",
            "kB/s",
            "CALLS/s",
            "CPU ms/s",
            "LISTENERS",
            "REFUSED",
            "SLOWED",
            "THINNED");
    for (Row each : rows) {
      table.row(
          each.group(),
          each.budget(),
          each.per().equals(Budget.Scope.OBJECT.name().toLowerCase(Locale.ROOT))
              ? "callers of " + each.owner()
              : each.owner(),
          used(each.bytes() / KILO, each.maxBytes() == null ? null : each.maxBytes() / KILO),
          used(each.calls(), each.maxCalls()),
          used(each.processorMillis(), each.maxProcessorMillis()),
          used(each.listeners(), each.maxListeners()),
          Long.toString(each.refused()),
          Long.toString(each.slowed()),
          Long.toString(each.thinned()));
    }
    answer.table(
        rows, table, "Nobody has used a budget of these robots, or their policy declares none.");
    if (!answer.isJson()) {
      survey
          .reports()
          .forEach(
              (group, report) -> {
                if (report.radio().max() > 0) {
                  String sentence = radio(group, report.radio());
                  answer.line(sentence, sentence + ".");
                }
              });
      survey.silent().forEach(each -> answer.note("no answer of " + each));
    }
  }

  private static String used(double used, @Nullable Double limit) {
    return number(used) + (limit == null ? "" : " of " + number(limit));
  }

  private static String number(double value) {
    String text = String.format(Locale.ROOT, "%.1f", value);
    return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
  }

  private static String radio(String group, RadioUse use) {
    List<String> fewer = new ArrayList<>();
    for (ListenerPriority each : ListenerPriority.values()) {
      int oneIn = each.ordinal() < use.oneIn().size() ? use.oneIn().get(each.ordinal()) : 1;
      if (oneIn > 1) {
        fewer.add(each.text() + "s get one reading in " + oneIn);
      }
    }
    return group
        + ": the radio carries "
        + number(use.rate() / KILO)
        + " of "
        + number(use.max() / KILO)
        + " kB/s; "
        + (fewer.isEmpty() ? "every reading is sent" : String.join(", ", fewer))
        + "; "
        + use.thinned()
        + " readings were not sent";
  }
}
