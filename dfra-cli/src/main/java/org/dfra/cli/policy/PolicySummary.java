package org.dfra.cli.policy;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.PolicyExplanation;
import org.dfra.core.policy.PolicyExplanation.Outcome;
import org.dfra.core.policy.PolicyVisibility;
import org.dfra.core.policy.method.CalledMethod;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.core.policy.method.InterfaceCatalogue.CataloguedInterface;
import org.dfra.core.policy.method.MethodKind;
import org.dfra.security.Behalf;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.dfra.security.Visibility.ListedService;

/** Who may call which kinds of methods, over all methods of DFRA's and River's interfaces. */
final class PolicySummary {

  /** Names that no rule of a policy has by chance. */
  private static final String CALLED = "called-robot";

  /** What lookup services list, in the summary. */
  private static final String SERVICES = "services";

  private static final String OTHER = "other-member";

  private PolicySummary() {}

  /**
   * A row of the summary.
   *
   * @param caller such as {@code operator}
   * @param outcomes by the kind of method: permit, deny, some or depends; and, if the policy hides
   *     something, what is seen in lookup services: shown, hidden or some
   */
  record CallerRow(String caller, Map<String, String> outcomes) {}

  static List<CallerRow> of(Policy policy) {
    String team = policy.team();
    List<CallerRow> rows = new ArrayList<>();
    rows.add(row("own", policy, caller(Standing.OWN, team, MemberRole.ROBOT, CALLED)));
    for (MemberRole each : List.of(MemberRole.OPERATOR, MemberRole.ROBOT, MemberRole.OBSERVER)) {
      rows.add(row(each.text(), policy, caller(Standing.MEMBER, team, each, OTHER)));
    }
    rows.add(row("delegate", policy, delegate(team)));
    rows.add(row("expired", policy, caller(Standing.EXPIRED, team, MemberRole.OPERATOR, OTHER)));
    rows.add(row("stranger", policy, Caller.stranger("")));
    return rows;
  }

  /** Another robot that calls on an operator's behalf. */
  private static Caller delegate(String team) {
    return caller(Standing.MEMBER, team, MemberRole.ROBOT, OTHER)
        .onBehalfOf(Behalf.of(new Member(team, MemberRole.OPERATOR, OTHER)));
  }

  private static Caller caller(Standing standing, String team, MemberRole role, String name) {
    return new Caller(standing, Optional.of(new Member(team, role, name)), "");
  }

  private static CallerRow row(String name, Policy policy, Caller caller) {
    InterfaceCatalogue catalogue = InterfaceCatalogue.builtIn();
    Map<MethodKind, Set<Outcome>> found = new LinkedHashMap<>();
    for (CataloguedInterface type : catalogue.all()) {
      for (String each : type.declared().keySet()) {
        CalledMethod method = CalledMethod.of(type, each, catalogue);
        found
            .computeIfAbsent(method.kind(), unused -> EnumSet.noneOf(Outcome.class))
            .add(outcome(policy, caller, method));
      }
    }
    Map<String, String> outcomes = new LinkedHashMap<>();
    found.forEach((kind, each) -> outcomes.put(kind.text(), inWords(each)));
    if (!policy.visibility().isEmpty()) {
      ListedService service = new ListedService(CALLED, "", Set.of());
      outcomes.put(SERVICES, seen(PolicyVisibility.explain(policy, caller, service, "")));
      for (String each : PolicyVisibility.records()) {
        outcomes.put(
            "entry " + each, seen(PolicyVisibility.explain(policy, caller, service, each)));
      }
    }
    return new CallerRow(name, outcomes);
  }

  /** As the guard decides: a call on somebody's behalf must be permitted to both. */
  private static Outcome outcome(Policy policy, Caller caller, CalledMethod method) {
    Optional<Member> principal = caller.behalf().flatMap(Behalf::principal);
    if (principal.isEmpty() || method.kind() == MethodKind.STOP) {
      return PolicyExplanation.of(policy, caller.alone(), method, CALLED, "").outcome();
    }
    Caller delegating = new Caller(Standing.MEMBER, principal, "");
    Outcome bearers = PolicyExplanation.of(policy, caller, method, CALLED, "").outcome();
    Outcome principals = PolicyExplanation.of(policy, delegating, method, CALLED, "").outcome();
    if (bearers == Outcome.DENY || principals == Outcome.DENY) {
      return Outcome.DENY;
    }
    return bearers == principals ? bearers : Outcome.DEPENDS;
  }

  private static String seen(List<PolicyVisibility.Explained> parts) {
    long shown = parts.stream().filter(PolicyVisibility.Explained::isShown).count();
    return shown == 0 ? "hidden" : shown == parts.size() ? "shown" : "some";
  }

  private static String inWords(Set<Outcome> outcomes) {
    if (outcomes.contains(Outcome.DEPENDS)) {
      return "depends";
    }
    return outcomes.size() == 1
        ? outcomes.iterator().next().name().toLowerCase(Locale.ROOT)
        : "some";
  }
}
