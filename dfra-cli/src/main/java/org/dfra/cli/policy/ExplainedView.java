package org.dfra.cli.policy;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.PolicyVisibility.Explained;
import org.dfra.core.policy.VisibilityRule;
import org.dfra.security.Caller;
import org.jspecify.annotations.Nullable;

/**
 * What a caller sees in lookup services, in the command's output.
 *
 * @param what as it was asked
 * @param parts of it
 */
record ExplainedView(String what, String caller, List<Part> parts) {

  /**
   * A part.
   *
   * @param component of a record of attributes; empty for all of it
   * @param reason the rule with its place, or why none decides
   */
  record Part(String component, boolean isShown, String reason) {}

  static ExplainedView of(String what, Policy policy, Caller caller, List<Explained> explained) {
    List<Part> parts = new ArrayList<>();
    explained.forEach(
        each -> parts.add(new Part(each.component(), each.isShown(), reason(each, policy))));
    String who = caller.member().map(Object::toString).orElse("stranger");
    return new ExplainedView(what, who, parts);
  }

  private static String reason(Explained part, Policy policy) {
    @Nullable VisibilityRule rule = part.rule();
    if (part.isNeeded() && rule != null && rule.hides()) {
      return "since who may stop an effector must find it, whatever <hide> "
          + rule.name()
          + " ("
          + rule.place()
          + ") says";
    }
    return rule == null
        ? "since no rule of " + policy + " hides it"
        : "by <" + rule.text() + "> " + rule.name() + " (" + rule.place() + ")";
  }

  /** For people: parts with one reason are in one line. */
  List<String> lines() {
    Map<String, List<String>> byReason = new LinkedHashMap<>();
    for (Part each : parts) {
      String verdict = (each.isShown() ? "shown " : "hidden ") + each.reason();
      byReason.computeIfAbsent(verdict, unused -> new ArrayList<>()).add(each.component());
    }
    List<String> lines = new ArrayList<>();
    byReason.forEach(
        (verdict, components) ->
            lines.add(
                what
                    + " for "
                    + caller
                    + ": "
                    + (components.get(0).isEmpty() || parts.size() == 1
                        ? ""
                        : String.join(", ", components) + " ")
                    + verdict
                    + "."));
    return lines;
  }
}
