package org.dfra.core.policy;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dfra.core.config.SourceLocation;
import org.dfra.core.policy.method.CalledMethod;
import org.dfra.security.Caller;
import org.jspecify.annotations.Nullable;

/** A rule of a policy: whom and what it is about, its conditions, and what it decides. */
public final class PolicyRule {

  /** What a rule decides. */
  public enum Effect {
    PERMIT,
    DENY;

    /** The element in a policy. */
    public String text() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  private final String name;
  private final Effect effect;
  private final CallerCriteria callers;
  private final CallCriteria calls;
  private final List<PolicyCondition> conditions;
  private final Obligations obligations;
  private final SourceLocation place;

  PolicyRule(
      String name,
      Effect effect,
      CallerCriteria callers,
      CallCriteria calls,
      List<PolicyCondition> conditions,
      Obligations obligations,
      SourceLocation place) {
    this.name = name;
    this.effect = effect;
    this.callers = callers;
    this.calls = calls;
    this.conditions = List.copyOf(conditions);
    this.obligations = obligations;
    this.place = place;
  }

  /** Its name, unique in its policy; {@code line 12} if it was given none. */
  public String name() {
    return name;
  }

  /** What it decides. */
  public Effect effect() {
    return effect;
  }

  /** What it obliges to. */
  public Obligations obligations() {
    return obligations;
  }

  /** The end of its start tag. */
  public SourceLocation place() {
    return place;
  }

  /** Whether it applies only if facts hold, and not to every call that it is about. */
  public boolean isConditional() {
    return !conditions.isEmpty();
  }

  /** Whether a condition is about the robot's position. */
  boolean needsPosition() {
    return conditions.stream().anyMatch(PolicyCondition.Within.class::isInstance);
  }

  /** Its conditions, each as the rest of a sentence that begins with "only". */
  public List<String> conditions() {
    return conditions.stream().map(PolicyCondition::text).toList();
  }

  /**
   * Why it is not about a call, as parts of a sentence: one about the caller, one about what is
   * called. Conditions do not count.
   *
   * @param robot the robot that the called object belongs to; empty if to none
   * @param object name of the called object; empty if it has none
   * @return empty if it is about the call
   */
  List<String> mismatches(Caller caller, CalledMethod method, String robot, String object) {
    List<String> reasons = new ArrayList<>();
    @Nullable String who = callers.mismatch(caller, robot, effect);
    if (who != null) {
      reasons.add(who);
    }
    @Nullable String what = calls.mismatch(method, robot, object, effect);
    if (what != null) {
      reasons.add(what);
    }
    return reasons;
  }

  /**
   * Why it is not about a call, if it almost is: it is about what is called but not about the
   * caller, or it names the caller and is not about what is called.
   *
   * @return null if it is about the call, or far from it
   */
  @Nullable String nearMiss(Caller caller, CalledMethod method, String robot, String object) {
    @Nullable String who = callers.mismatch(caller, robot, effect);
    @Nullable String what = calls.mismatch(method, robot, object, effect);
    if (who != null) {
      return what == null ? who : null;
    }
    return callers.isNamed() ? what : null;
  }

  /** Whether its conditions hold, as far as they must for its effect. */
  boolean appliesNow(PolicyFacts facts) {
    for (int i = 0; i < conditions.size(); i++) { // without an iterator: it is called often
      if (!conditions.get(i).evaluate(facts).applies(effect)) {
        return false;
      }
    }
    return true;
  }

  @Override
  public String toString() {
    return effect.text() + " \"" + name + "\" (" + place + ")";
  }
}
