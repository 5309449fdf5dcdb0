package org.dfra.core.policy;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dfra.core.budget.Budget;
import org.dfra.core.budget.Budgets;
import org.dfra.core.budget.RadioLimit;
import org.dfra.core.config.ConfigurationFaults;
import org.dfra.core.config.Substitution;
import org.dfra.core.config.XmlValues;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.geometry.GeoPosition;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.jdom2.Element;
import org.jspecify.annotations.Nullable;

/**
 * Reads one policy. The schema validation finds some faults; this class and {@link RuleReader}
 * record all others and continue, so that all are reported at once.
 */
final class PolicyReader {

  private final XmlValues values;
  private final ConfigurationFaults faults;
  private final InterfaceCatalogue catalogue;

  PolicyReader(String file, InterfaceCatalogue catalogue, ConfigurationFaults faults) {
    this.values = new XmlValues(file, new Substitution(name -> null, faults), faults);
    this.faults = faults;
    this.catalogue = catalogue;
  }

  /** The policy; empty, with the reasons among the faults, if it has any. */
  Optional<Policy> policy(Element root, String digest) {
    String team = root.getAttributeValue("team");
    values.check(root, team == null ? null : teamFault(team));
    long version = version(root);
    Map<String, PolicyRegion> regions = new HashMap<>();
    XmlValues.UniqueNames regionNames = values.uniqueNames();
    for (Element each : root.getChildren("region", root.getNamespace())) {
      @Nullable PolicyRegion region = region(each, regionNames);
      if (region != null) {
        regions.put(region.name(), region);
      }
    }
    List<PolicyRule> rules = new ArrayList<>();
    List<VisibilityRule> visibility = new ArrayList<>();
    XmlValues.UniqueNames ruleNames = values.uniqueNames();
    for (Element each : root.getChildren()) {
      RuleReader reader = new RuleReader(each, values, catalogue, regions, ruleNames);
      switch (each.getName()) {
        case "permit", "deny" -> reader.rule().ifPresent(rules::add);
        case "show", "hide" -> reader.visibility().ifPresent(visibility::add);
        default -> {
          // a region
        }
      }
    }
    values.check(root, countFault(rules.size()));
    Budgets budgets = budgets(root, regions);
    values.check(
        root,
        visibility.size() > PolicyXml.MAX_VISIBILITY_RULES
            ? "the policy has "
                + visibility.size()
                + " <hide> and <show>, at most "
                + PolicyXml.MAX_VISIBILITY_RULES
                + " are read"
            : null);
    return faults.isEmpty() && team != null
        ? Optional.of(
            new Policy(team, version, rules, visibility, budgets, digest, values.place(root)))
        : Optional.empty();
  }

  private Budgets budgets(Element root, Map<String, PolicyRegion> regions) {
    List<Budget> budgets = new ArrayList<>();
    List<RadioLimit> radios = new ArrayList<>();
    XmlValues.UniqueNames names = values.uniqueNames();
    for (Element each : root.getChildren()) {
      RuleReader rule = new RuleReader(each, values, catalogue, regions, names);
      switch (each.getName()) {
        case "budget" -> new BudgetReader(each, values, rule).budget(names).ifPresent(budgets::add);
        case "radio" -> new BudgetReader(each, values, rule).radio().ifPresent(radios::add);
        default -> {}
      }
    }
    int count = budgets.size() + radios.size();
    values.check(
        root,
        count > PolicyXml.MAX_BUDGETS
            ? "the policy has "
                + count
                + " budgets and radios, at most "
                + PolicyXml.MAX_BUDGETS
                + " are read; combine some"
            : null);
    return new Budgets(budgets, radios);
  }

  private @Nullable String countFault(int rules) {
    if (rules > PolicyXml.MAX_RULES) {
      return "the policy has " + rules + " rules, at most " + PolicyXml.MAX_RULES + " are read";
    }
    return rules == 0 && faults.isEmpty()
        ? "the policy has no rule, so it refuses every call; add a <permit>"
        : null;
  }

  private static @Nullable String teamFault(String team) {
    try {
      Member unused = new Member(team, MemberRole.OPERATOR, "any");
      return null;
    } catch (IllegalArgumentException e) {
      return e.getMessage();
    }
  }

  /** The version; 0 if it is absent, which is the schema's fault, or faulty. */
  long version(Element root) {
    String written = root.getAttributeValue("version");
    if (written != null) {
      if (written.matches("[0-9]{1,18}")) {
        return Long.parseLong(written);
      }
      values.check(root, "version \"" + written + "\" is not a whole number of at most 18 digits");
    }
    return 0;
  }

  private @Nullable PolicyRegion region(Element element, XmlValues.UniqueNames names) {
    String name = element.getAttributeValue("name");
    if (name == null) {
      return null; // the schema's fault
    }
    values.check(element, NamePattern.nameFault(name));
    names.requireFirst(element, name, "region " + name, "rename one");
    List<GeoPosition> corners = new ArrayList<>();
    List<Element> written = element.getChildren("corner", element.getNamespace());
    for (Element each : written) {
      @Nullable GeoPosition corner = corner(each);
      if (corner != null) {
        corners.add(corner);
      }
    }
    if (corners.size() == written.size()) {
      values.check(element, PolicyRegion.fault(corners));
    }
    return new PolicyRegion(name, corners); // also a faulty one: rules may name it
  }

  private @Nullable GeoPosition corner(Element element) {
    String latitude = element.getAttributeValue("latitude");
    String longitude = element.getAttributeValue("longitude");
    if (latitude == null || longitude == null) {
      return null; // the schema's fault
    }
    try {
      return new GeoPosition(Double.parseDouble(latitude), Double.parseDouble(longitude), 0);
    } catch (NumberFormatException e) {
      values.check(
          element,
          "corner "
              + latitude
              + ", "
              + longitude
              + " is not two numbers; write degrees, such as"
              + " 27.9506");
    } catch (IllegalArgumentException e) {
      values.check(element, e.getMessage());
    }
    return null;
  }
}
