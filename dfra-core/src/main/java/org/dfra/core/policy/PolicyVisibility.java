package org.dfra.core.policy;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Visibility;
import org.jspecify.annotations.Nullable;

/**
 * What a policy shows to one caller. The first rule that matches decides; what no rule matches is
 * shown.
 *
 * <p>Who may stop an effector must find it: a member, also one with an expired certificate, sees
 * each effector with the names of its robot and module, whatever the rules say.
 */
public final class PolicyVisibility implements Visibility {

  /** Every effector has an emergency stop. */
  static final String STOPPABLE = "org.dfra.flow.effector.Effector";

  private static final String MODULE = "org.dfra.persona.ModuleAttributes";
  private static final Set<String> NAMES = Set.of("robot", "name");

  /** Attributes and combinations of rules are few; this limit is for forged names of classes. */
  private static final int MAX_KNOWN = 10_000;

  private final Caller caller;
  private final List<VisibilityRule> rules;
  private final ConcurrentHashMap<Question, Boolean> known = new ConcurrentHashMap<>();

  /**
   * What a decision about attributes depends on.
   *
   * @param rules a bit for each rule that is about the service
   * @param component empty for all
   */
  private record Question(long rules, String type, String component) {}

  private PolicyVisibility(Caller caller, List<VisibilityRule> rules) {
    this.caller = caller;
    this.rules = rules;
  }

  /** What a policy shows to a caller. */
  public static Visibility of(Policy policy, Caller caller) {
    List<VisibilityRule> concerned =
        policy.visibility().stream().filter(each -> each.mayConcern(caller)).toList();
    return concerned.stream().noneMatch(VisibilityRule::hides)
        ? Visibility.ALL
        : new PolicyVisibility(caller, concerned);
  }

  /**
   * What is decided about one attribute, or about a service.
   *
   * @param component of the record; empty for a service, or for all of a record whose components
   *     are not known
   * @param rule which decides; null if none matches, so that it is shown
   * @param isNeeded whether it is shown whatever the rules say, since its owner may be stopped
   */
  public record Explained(
      String component, boolean isShown, @Nullable VisibilityRule rule, boolean isNeeded) {}

  /** The records of attributes in dfra-api, as rules name them. */
  public static List<String> records() {
    return EntryPattern.records().keySet().stream()
        .map(type -> new EntryPattern(type, "").toString())
        .toList();
  }

  /**
   * Explains what a caller sees.
   *
   * @param entry attributes as a rule names them; empty for the service itself
   * @return a line for each component of the record
   * @throws IllegalArgumentException if there are no such attributes; the message says what there
   *     is
   */
  public static List<Explained> explain(
      Policy policy, Caller caller, ListedService service, String entry) {
    PolicyVisibility all = new PolicyVisibility(caller, policy.visibility());
    Shown shown = all.of(service);
    if (caller.standing() == Standing.OWN) {
      return List.of(new Explained("", true, null, false));
    }
    if (entry.isEmpty()) {
      return List.of(
          new Explained(
              "", shown.isShown(), shown.deciding(VisibilityRule::isOfService), shown.isStoppable));
    }
    EntryPattern named = EntryPattern.of(entry);
    List<String> components =
        named.component().isEmpty()
            ? EntryPattern.records().getOrDefault(named.type(), List.of(""))
            : List.of(named.component());
    List<Explained> explained = new ArrayList<>();
    for (String each : components) {
      @Nullable VisibilityRule rule =
          shown.deciding(
              it -> each.isEmpty() ? it.isOfAll(named.type()) : it.isOf(named.type(), each));
      boolean isShown =
          each.isEmpty() ? shown.isShown(named.type()) : shown.isShown(named.type(), each);
      boolean isNeeded = shown.isStoppable && isName(named.type(), each);
      explained.add(new Explained(each, isShown, rule, isNeeded));
    }
    return explained;
  }

  @Override
  public boolean isComplete() {
    return false;
  }

  @Override
  public Shown of(ListedService service) {
    long matching = 0;
    for (int i = 0; i < rules.size(); i++) {
      if (rules.get(i).mismatch(caller, service) == null) {
        matching |= 1L << i;
      }
    }
    boolean isStoppable =
        caller.standing() != Standing.STRANGER && service.types().contains(STOPPABLE);
    return new Shown(matching, isStoppable);
  }

  /** What is seen of one service. */
  final class Shown implements OfService {

    private final long matching;
    private final boolean isStoppable;

    private Shown(long matching, boolean isStoppable) {
      this.matching = matching;
      this.isStoppable = isStoppable;
    }

    @Override
    public boolean isShown() {
      return isStoppable || decide(VisibilityRule::isOfService);
    }

    @Override
    public boolean isShown(String type, String component) {
      return (isStoppable && isName(type, component))
          || answer(type, component, each -> each.isOf(type, component));
    }

    @Override
    public boolean isShown(String type) {
      return answer(type, "", each -> each.isOfAll(type));
    }

    private boolean answer(String type, String component, Predicate<VisibilityRule> isAbout) {
      Question question = new Question(matching, type, component);
      @Nullable Boolean before = known.get(question);
      if (before != null) {
        return before;
      }
      if (known.size() >= MAX_KNOWN) {
        known.clear();
      }
      boolean isShown = decide(isAbout);
      known.put(question, isShown);
      return isShown;
    }

    private boolean decide(Predicate<VisibilityRule> isAbout) {
      @Nullable VisibilityRule rule = deciding(isAbout);
      return rule == null || !rule.hides();
    }

    /** The first rule that matches; null if none does. */
    private @Nullable VisibilityRule deciding(Predicate<VisibilityRule> isAbout) {
      for (int i = 0; i < rules.size(); i++) {
        if ((matching & 1L << i) != 0 && isAbout.test(rules.get(i))) {
          return rules.get(i);
        }
      }
      return null;
    }
  }

  private static boolean isName(String type, String component) {
    return type.equals(MODULE) && NAMES.contains(component);
  }
}
