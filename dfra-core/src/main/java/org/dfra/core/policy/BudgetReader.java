package org.dfra.core.policy;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.core.budget.Budget;
import org.dfra.core.budget.BudgetLimits;
import org.dfra.core.budget.RadioLimit;
import org.dfra.core.config.XmlValues;
import org.dfra.core.policy.PolicyRule.Effect;
import org.jdom2.Element;
import org.jspecify.annotations.Nullable;

/** Reads one {@code <budget>} or {@code <radio>}, and records its faults. */
final class BudgetReader {

  private static final Pattern BYTES = Pattern.compile("([0-9]{1,9}(?:\\.[0-9]{1,3})?)(B|kB|MB)/s");
  private static final Pattern CALLS = Pattern.compile("([0-9]{1,6})/s");
  private static final Pattern MILLIS = Pattern.compile("([0-9]{1,6})ms/s");
  private static final Pattern COUNT = Pattern.compile("([0-9]{1,6})");
  private static final double MILLIS_PER_SECOND = 1000;

  private final Element element;
  private final XmlValues values;
  private final RuleReader rule;
  private boolean isFaulty;

  /**
   * @param rule reads the attributes that rules have too
   */
  BudgetReader(Element element, XmlValues values, RuleReader rule) {
    this.element = element;
    this.values = values;
    this.rule = rule;
  }

  private void fault(@Nullable String sentence) {
    values.check(element, sentence);
    isFaulty |= sentence != null;
  }

  /**
   * The budget; empty, with the reasons among the faults, if it has any.
   *
   * @param names of the policy's budgets
   */
  Optional<Budget> budget(XmlValues.UniqueNames names) {
    String name = name(names);
    // A robot's own processes have budgets only if these name them.
    CallerCriteria callers = rule.callers(CallerCriteria.OTHERS);
    NamePattern robots = rule.names("robot");
    NamePattern objects = rule.names("object");
    boolean isPerObject = isSecond("per", "caller", "object");
    boolean isSlowing = isSecond("exceeded", "refuse", "slow");
    BudgetLimits limits =
        new BudgetLimits(
            bytes("bytes"),
            limit("calls", CALLS, "calls=\"100/s\""),
            limit("processor-time", MILLIS, "processor-time=\"50ms/s\"") / MILLIS_PER_SECOND,
            limit("listeners", COUNT, "listeners=\"8\""));
    fault(
        !isFaulty && limits.equals(BudgetLimits.NONE)
            ? "the budget limits nothing; add bytes, calls, processor-time or listeners"
            : null);
    return isFaulty || rule.isFaulty()
        ? Optional.empty()
        : Optional.of(
            new Budget(
                name,
                caller -> callers.mismatch(caller, "", Effect.DENY) == null,
                robots::matches,
                objects::matches,
                isPerObject ? Budget.Scope.OBJECT : Budget.Scope.CALLER,
                limits,
                isSlowing,
                values.place(element)));
  }

  /** What the radio carries; empty, with the reason among the faults, if that is no rate. */
  Optional<RadioLimit> radio() {
    NamePattern robots = rule.names("robot");
    double max = bytes("max"); // its absence is the schema's fault
    return isFaulty || rule.isFaulty()
        ? Optional.empty()
        : Optional.of(new RadioLimit(max, robots::matches));
  }

  private String name(XmlValues.UniqueNames names) {
    String written = element.getAttributeValue("name");
    if (written == null) {
      return "line-" + values.place(element).line();
    }
    fault(NamePattern.nameFault(written));
    names.requireFirst(element, written, "budget " + written, "rename one");
    return written;
  }

  /** Whether an attribute has the second of its two values; the first is the default. */
  private boolean isSecond(String attribute, String first, String second) {
    String written = element.getAttributeValue(attribute);
    boolean isKnown = written == null || written.equals(first) || written.equals(second);
    fault(isKnown ? null : attribute + " is \"" + written + "\"; write " + first + " or " + second);
    return second.equals(written);
  }

  private double bytes(String attribute) {
    String written = element.getAttributeValue(attribute);
    if (written == null) {
      return BudgetLimits.UNLIMITED;
    }
    Matcher parts = BYTES.matcher(written);
    double value = parts.matches() ? Double.parseDouble(parts.group(1)) : 0;
    if (!(value > 0)) {
      return noLimit(attribute, written, attribute + "=\"64kB/s\", in B, kB or MB");
    }
    return switch (parts.group(2)) {
      case "B" -> value;
      case "kB" -> value * 1e3;
      default -> value * 1e6;
    };
  }

  private double limit(String attribute, Pattern form, String example) {
    String written = element.getAttributeValue(attribute);
    if (written == null) {
      return BudgetLimits.UNLIMITED;
    }
    Matcher parts = form.matcher(written);
    double value = parts.matches() ? Double.parseDouble(parts.group(1)) : 0;
    return value > 0 ? value : noLimit(attribute, written, example);
  }

  private double noLimit(String attribute, String written, String example) {
    fault(
        "<"
            + element.getName()
            + "> "
            + attribute
            + " \""
            + written
            + "\" is no limit above 0; write it as "
            + example);
    return BudgetLimits.UNLIMITED;
  }
}
