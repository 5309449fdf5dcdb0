package org.dfra.core.policy;

import java.util.List;
import java.util.stream.Collectors;
import org.dfra.core.config.SourceLocation;
import org.dfra.core.policy.PolicyRule.Effect;
import org.dfra.core.policy.method.InterfaceCatalogue.CataloguedInterface;
import org.dfra.security.Caller;
import org.dfra.security.Visibility.ListedService;
import org.jspecify.annotations.Nullable;

/**
 * A rule about what callers see in a lookup service. Immutable.
 *
 * <p>Its effect is that of a denial if it hides, and that of a permit if it shows: what is unknown
 * leads to hiding.
 */
public final class VisibilityRule {

  private final String name;
  private final Effect effect;
  private final CallerCriteria callers;
  private final NamePattern robots;
  private final NamePattern objects;
  private final List<CataloguedInterface> types;
  private final List<EntryPattern> entries;
  private final SourceLocation place;

  /**
   * @param types a service has one of them; empty for all
   * @param entries what it is about; empty for the service with all its entries
   */
  VisibilityRule(
      String name,
      Effect effect,
      CallerCriteria callers,
      NamePattern robots,
      NamePattern objects,
      List<CataloguedInterface> types,
      List<EntryPattern> entries,
      SourceLocation place) {
    this.name = name;
    this.effect = effect;
    this.callers = callers;
    this.robots = robots;
    this.objects = objects;
    this.types = List.copyOf(types);
    this.entries = List.copyOf(entries);
    this.place = place;
  }

  /** Its name, unique in its policy. */
  public String name() {
    return name;
  }

  /** The end of its start tag. */
  public SourceLocation place() {
    return place;
  }

  /** Whether it hides; otherwise it shows. */
  public boolean hides() {
    return effect == Effect.DENY;
  }

  /** The element in a policy. */
  public String text() {
    return hides() ? "hide" : "show";
  }

  /** Whether it may be about a caller, which can depend on the robot. */
  boolean mayConcern(Caller caller) {
    return new CallerCriteria(
                callers.standings(), callers.roles(), callers.members(), null, callers.behalf())
            .mismatch(caller, "", effect)
        == null;
  }

  /** Why it is not about a service and a caller, as a part of a sentence; null if it is. */
  @Nullable String mismatch(Caller caller, ListedService service) {
    @Nullable String who = callers.mismatch(caller, service.robot(), effect);
    if (who != null) {
      return who;
    }
    if (!types.isEmpty()
        && types.stream().noneMatch(each -> service.types().contains(each.name()))) {
      return "the service is not known to be a "
          + types.stream().map(CataloguedInterface::simpleName).collect(Collectors.joining(" or "));
    }
    if (!robots.matches(service.robot())) {
      return "the robot is " + orNone(service.robot()) + ", not " + robots;
    }
    return objects.matches(service.object())
        ? null
        : "the object is " + orNone(service.object()) + ", not " + objects;
  }

  private static String orNone(String name) {
    return name.isEmpty() ? "not given" : name;
  }

  /** Whether it is about a service as a whole. */
  boolean isOfService() {
    return entries.isEmpty();
  }

  /** Whether it decides about a component of a record. */
  boolean isOf(String type, String component) {
    return entries.isEmpty() || entries.stream().anyMatch(each -> each.matches(type, component));
  }

  /** Whether it decides about a record as a whole: one hidden component hides it. */
  boolean isOfAll(String type) {
    return entries.isEmpty() || entries.stream().anyMatch(each -> each.matchesWhole(type, hides()));
  }

  @Override
  public String toString() {
    return text() + " \"" + name + "\" (" + place + ")";
  }
}
