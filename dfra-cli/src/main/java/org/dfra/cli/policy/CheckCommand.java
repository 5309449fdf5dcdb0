package org.dfra.cli.policy;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.method.MethodKind;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.report.terminal.Table;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra policy check}. */
@Command(
    name = "check",
    description = "Checks a policy, and shows who may call which kinds of methods.",
    footer = {
      "",
      "Exits with 1 if the policy has faults, and prints each with file and line. In the table,",
      "\"some\" means that the policy permits some methods of the kind and denies others, and",
      "\"depends\" that it depends on a condition, a rate or a confirmation. The objects that are",
      "called belong to another robot than the caller, except in the column OWN. In the",
      "column DELEGATE a robot calls on an operator's behalf. If the policy has <hide>,",
      "the rows \"services\" and \"entry\" say what callers see in lookup services: shown,",
      "hidden, or some. They are about services without a name or a type that a rule names."
    })
final class CheckCommand implements Callable<Integer> {

  /** Callers of the summary that should be able to stop a robot. */
  private static final Set<String> MEMBERS = Set.of("operator", "robot", "observer");

  private static final String PERMITTED = "permit";

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private PolicyFile policy;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  @Override
  public Integer call() {
    Policy read = policy.read();
    List<PolicySummary.CallerRow> rows = PolicySummary.of(read);
    Table table =
        new Table(
            Stream.concat(
                    Stream.of("KIND"),
                    rows.stream().map(row -> row.caller().toUpperCase(Locale.ROOT)))
                .toArray(String[]::new));
    for (String what : rows(rows)) {
      table.row(
          Stream.concat(
                  Stream.of(what), rows.stream().map(row -> row.outcomes().getOrDefault(what, "-")))
              .toArray(String[]::new));
    }
    if (!answer.isJson()) {
      answer.line(
          rows,
          read.place().file()
              + " is valid: "
              + read
              + ", "
              + read.rules().size()
              + (read.rules().size() == 1 ? " rule" : " rules")
              + budgets(read.budgets().all().size())
              + ".");
    }
    answer.table(rows, table, "The policy is about no method.");
    List<String> stopping =
        rows.stream()
            .filter(row -> MEMBERS.contains(row.caller()))
            .filter(row -> !PERMITTED.equals(row.outcomes().get(MethodKind.STOP.text())))
            .map(row -> row.caller() + "s")
            .toList();
    if (!stopping.isEmpty()) {
      answer.note(
          "this policy does not always permit an emergency stop to "
              + String.join(", ", stopping)
              + "; unless that is meant, let it begin with <permit name=\"stop\""
              + " standing=\"member,expired\" kind=\"stop\"/>");
    }
    return ExitCode.SUCCESS;
  }

  private static String budgets(int count) {
    return count == 0 ? "" : ", " + count + (count == 1 ? " budget" : " budgets");
  }

  /** The kinds of methods, and what lookup services show if the policy hides something. */
  private static Set<String> rows(List<PolicySummary.CallerRow> summary) {
    Set<String> rows = new LinkedHashSet<>();
    for (MethodKind kind : MethodKind.values()) {
      rows.add(kind.text());
    }
    summary.forEach(row -> rows.addAll(row.outcomes().keySet()));
    return rows;
  }
}
