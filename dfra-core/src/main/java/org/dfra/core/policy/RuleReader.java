package org.dfra.core.policy;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dfra.core.config.NearestName;
import org.dfra.core.config.XmlValues;
import org.dfra.core.policy.PolicyRule.Effect;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.core.policy.method.InterfaceCatalogue.CataloguedInterface;
import org.dfra.core.policy.method.MethodKind;
import org.dfra.security.Caller.Standing;
import org.dfra.security.MemberRole;
import org.jdom2.Element;
import org.jspecify.annotations.Nullable;

/**
 * Reads one {@code <permit>}, {@code <deny>}, {@code <show>} or {@code <hide>}, and records its
 * faults. {@link BudgetReader} uses it for the attributes that budgets have too.
 */
final class RuleReader {

  private static final String ANY = "*";

  private final Element element;
  private final XmlValues values;
  private final InterfaceCatalogue catalogue;
  private final Map<String, PolicyRegion> regions;
  private final XmlValues.UniqueNames names;
  private final Effect effect;
  private boolean isFaulty;

  /**
   * @param names of the policy's rules
   */
  RuleReader(
      Element element,
      XmlValues values,
      InterfaceCatalogue catalogue,
      Map<String, PolicyRegion> regions,
      XmlValues.UniqueNames names) {
    this.element = element;
    this.values = values;
    this.catalogue = catalogue;
    this.regions = regions;
    this.names = names;
    this.effect =
        List.of("permit", "show").contains(element.getName()) ? Effect.PERMIT : Effect.DENY;
  }

  /** The rule; empty, with the reasons among the faults, if it has any. */
  Optional<PolicyRule> rule() {
    String name = name();
    CallerCriteria callers = callers(CallerCriteria.defaultStandings(effect));
    CallCriteria calls = calls();
    ConditionReader conditions = new ConditionReader(values, regions);
    List<PolicyCondition> held = new ArrayList<>();
    for (Element each : element.getChildren()) {
      conditions.condition(each).ifPresent(held::add);
    }
    Obligations obligations = conditions.obligations(element, effect);
    return isFaulty || conditions.isFaulty()
        ? Optional.empty()
        : Optional.of(
            new PolicyRule(name, effect, callers, calls, held, obligations, values.place(element)));
  }

  /** Whether a fault was recorded. */
  boolean isFaulty() {
    return isFaulty;
  }

  /** The rule about what is seen; empty, with the reasons among the faults, if it has any. */
  Optional<VisibilityRule> visibility() {
    String name = name();
    CallerCriteria callers = callers(CallerCriteria.OTHERS);
    fault(
        callers.standings().contains(Standing.OWN)
            ? "nothing is hidden from a robot's own processes; delete own from standing"
            : null);
    List<CataloguedInterface> types = new ArrayList<>();
    items("type").forEach(each -> interfaceNamed(each).ifPresent(types::add));
    List<EntryPattern> entries = new ArrayList<>();
    @Nullable String written = element.getAttributeValue("entry");
    List<String> items = written == null ? List.of() : NamePattern.items(written);
    fault(written != null && items.isEmpty() ? "entry names nothing; delete it, or write *" : null);
    for (String each : items) {
      try {
        entries.add(EntryPattern.of(each));
      } catch (IllegalArgumentException e) {
        fault(e.getMessage());
      }
    }
    NamePattern robots = names("robot");
    NamePattern objects = names("object");
    return isFaulty
        ? Optional.empty()
        : Optional.of(
            new VisibilityRule(
                name, effect, callers, robots, objects, types, entries, values.place(element)));
  }

  private void fault(@Nullable String sentence) {
    values.check(element, sentence);
    isFaulty |= sentence != null;
  }

  private String name() {
    String written = element.getAttributeValue("name");
    if (written == null) {
      return "line " + values.place(element).line();
    }
    fault(written.equals(Policy.DEFAULT_RULE) ? "a rule cannot be named default" : null);
    fault(NamePattern.nameFault(written));
    names.requireFirst(element, written, "rule " + written, "rename one");
    return written;
  }

  /**
   * The callers that it is about.
   *
   * @param byDefault their standings if it names none
   */
  CallerCriteria callers(Set<Standing> byDefault) {
    Set<Standing> standings = constants("standing", RuleReader::standing);
    String same = element.getAttributeValue("same-robot");
    boolean isWord = same == null || same.equals("yes") || same.equals("no");
    fault(isWord ? null : "same-robot is \"" + same + "\"; write yes or no");
    return new CallerCriteria(
        standings.isEmpty() ? byDefault : standings,
        constants("role", MemberRole::of),
        names("member"),
        same == null ? null : Boolean.valueOf(same.equals("yes")),
        new BehalfCriteria(constants("for-role", MemberRole::of), names("for-member")));
  }

  private static Standing standing(String text) {
    for (Standing each : Standing.values()) {
      if (CallerCriteria.text(each).equals(text)) {
        return each;
      }
    }
    throw new IllegalArgumentException(
        "standing \"" + text + "\" is none of own, member, expired, stranger");
  }

  /** The constants of an attribute; empty if it is absent or faulty. */
  private <T extends Enum<T>> Set<T> constants(String attribute, Function<String, T> parser) {
    Set<T> constants = new LinkedHashSet<>();
    for (String each : items(attribute)) {
      try {
        constants.add(parser.apply(each));
      } catch (IllegalArgumentException e) {
        fault(e.getMessage());
      }
    }
    return constants.isEmpty() ? constants : EnumSet.copyOf(constants);
  }

  /** The items of an attribute; empty if it is absent, or {@code *}. */
  private List<String> items(String attribute) {
    String written = element.getAttributeValue(attribute);
    if (written == null || written.strip().equals(ANY)) {
      return List.of();
    }
    List<String> items = NamePattern.items(written);
    fault(items.isEmpty() ? attribute + " names nothing; delete it, or write a name" : null);
    return items;
  }

  /** The names of an attribute; all if it is absent. */
  NamePattern names(String attribute) {
    String written = element.getAttributeValue(attribute);
    if (written == null) {
      return NamePattern.ANY;
    }
    @Nullable String fault = NamePattern.fault(written);
    fault(fault == null ? null : attribute + ": " + fault);
    return fault == null ? NamePattern.of(written) : NamePattern.ANY;
  }

  private CallCriteria calls() {
    List<CataloguedInterface> interfaces = new ArrayList<>();
    boolean areKnown = true;
    for (String each : items("interface")) {
      Optional<CataloguedInterface> found = interfaceNamed(each);
      found.ifPresent(interfaces::add);
      areKnown &= found.isPresent();
    }
    Set<String> methods = new LinkedHashSet<>(items("method"));
    if (areKnown) {
      methods.forEach(each -> fault(methodFault(each, interfaces)));
    }
    return new CallCriteria(
        interfaces, methods, constants("kind", MethodKind::of), names("robot"), names("object"));
  }

  private Optional<CataloguedInterface> interfaceNamed(String name) {
    List<CataloguedInterface> found = catalogue.named(name);
    if (found.size() == 1) {
      return Optional.of(found.get(0));
    }
    fault(
        found.isEmpty()
            ? "there is no remote interface \""
                + name
                + "\""
                + NearestName.hint(
                    name,
                    catalogue.simpleNames(),
                    "; write one of DFRA's or River's, or the full name of one on the class path")
            : "several interfaces are named "
                + name
                + "; write "
                + found.stream()
                    .map(CataloguedInterface::name)
                    .collect(Collectors.joining(" or ")));
    return Optional.empty();
  }

  private @Nullable String methodFault(String method, List<CataloguedInterface> interfaces) {
    Set<String> known = new TreeSet<>();
    interfaces.forEach(each -> known.addAll(each.methods()));
    if (interfaces.isEmpty()) {
      known.addAll(catalogue.methodNames());
    }
    if (known.contains(method)) {
      return null;
    }
    String owner =
        interfaces.isEmpty()
            ? "no remote interface"
            : interfaces.stream()
                .map(CataloguedInterface::simpleName)
                .collect(Collectors.joining(" or "));
    String all =
        interfaces.isEmpty() || known.isEmpty() ? "" : "; it has " + String.join(", ", known);
    return owner + " has no method \"" + method + "\"" + NearestName.hint(method, known, all);
  }
}
