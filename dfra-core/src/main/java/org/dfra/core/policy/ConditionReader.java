package org.dfra.core.policy;

import java.time.DateTimeException;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalTime;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.core.config.NearestName;
import org.dfra.core.config.XmlValues;
import org.dfra.core.policy.Obligations.RateLimit;
import org.dfra.core.policy.PolicyCondition.Daily;
import org.dfra.core.policy.PolicyCondition.During;
import org.dfra.core.policy.PolicyCondition.FactIs;
import org.dfra.core.policy.PolicyCondition.Within;
import org.dfra.core.policy.PolicyRule.Effect;
import org.jdom2.Element;
import org.jspecify.annotations.Nullable;

/** Reads the conditions and obligations of one rule, and records their faults. */
final class ConditionReader {

  private static final Pattern TIME_OF_DAY = Pattern.compile("[0-2][0-9]:[0-5][0-9]");
  private static final Pattern FACT = Pattern.compile("[a-z][a-z0-9_.-]{0,63}");
  private static final Pattern PERIOD = Pattern.compile("([0-9]{1,9})(ms|s|min|h)");

  private final XmlValues values;
  private final Map<String, PolicyRegion> regions;
  private boolean isFaulty;

  ConditionReader(XmlValues values, Map<String, PolicyRegion> regions) {
    this.values = values;
    this.regions = regions;
  }

  /** Whether a fault was recorded. */
  boolean isFaulty() {
    return isFaulty;
  }

  private void fault(Element element, @Nullable String sentence) {
    values.check(element, sentence);
    isFaulty |= sentence != null;
  }

  /** The condition of an element; empty if it is faulty, or no condition. */
  Optional<PolicyCondition> condition(Element element) {
    return Optional.ofNullable(
        switch (element.getName()) {
          case "within" -> within(element);
          case "when" -> when(element);
          case "while" -> fact(element);
          default -> null;
        });
  }

  private @Nullable PolicyCondition within(Element element) {
    String name = element.getAttributeValue("region");
    @Nullable PolicyRegion region = name == null ? null : regions.get(name);
    if (name != null && region == null) {
      fault(
          element,
          "there is no region \""
              + name
              + "\""
              + NearestName.hint(
                  name,
                  regions.keySet(),
                  "; add <region name=\"" + name + "\"> with its corners to the policy"));
    }
    isFaulty |= region == null;
    return region == null ? null : new Within(region);
  }

  private @Nullable PolicyCondition when(Element element) {
    String from = element.getAttributeValue("from");
    String until = element.getAttributeValue("until");
    if (from == null && until == null) {
      fault(element, "<when> has neither from nor until; write one, or delete the condition");
      return null;
    }
    try {
      return isTimeOfDay(from) || isTimeOfDay(until)
          ? daily(element, from, until)
          : during(element, from, until);
    } catch (DateTimeException e) {
      fault(
          element,
          "<when> from "
              + from
              + " until "
              + until
              + " is no time; write instants, such as 2026-11-28T06:00:00Z, or two times of day in"
              + " UTC, such as 06:00");
      return null;
    }
  }

  private static boolean isTimeOfDay(@Nullable String text) {
    return text != null && TIME_OF_DAY.matcher(text).matches();
  }

  private @Nullable PolicyCondition daily(
      Element element, @Nullable String from, @Nullable String until) {
    if (from == null || until == null) {
      fault(element, "<when> has one time of day; write from and until, or instants");
      return null;
    }
    Daily daily = new Daily(LocalTime.parse(from), LocalTime.parse(until));
    if (daily.from().equals(daily.until())) {
      fault(element, "<when> from " + from + " until " + until + " is never; write two times");
    }
    return daily;
  }

  private PolicyCondition during(Element element, @Nullable String from, @Nullable String until) {
    During during =
        new During(
            from == null ? null : Instant.parse(from), until == null ? null : Instant.parse(until));
    if (during.from() != null
        && during.until() != null
        && !during.from().isBefore(during.until())) {
      fault(element, "<when> from " + from + " until " + until + " is never; exchange them");
    }
    return during;
  }

  private @Nullable PolicyCondition fact(Element element) {
    String fact = element.getAttributeValue("fact");
    String value = element.getAttributeValue("is");
    if (fact == null || value == null) {
      isFaulty = true; // the schema's fault
      return null;
    }
    fault(
        element,
        FACT.matcher(fact).matches()
            ? null
            : "fact \"" + fact + "\" is no name; write it in lower case, such as load");
    return new FactIs(fact, value);
  }

  /** The obligations of a rule. */
  Obligations obligations(Element rule, Effect effect) {
    List<Element> rates = rule.getChildren("rate", rule.getNamespace());
    boolean isConfirmed = has(rule, "ask");
    if (effect == Effect.DENY && (isConfirmed || !rates.isEmpty())) {
      fault(
          rule,
          "a <deny> has <rate> or <ask>, which limit a permission; delete them, or write <permit>");
    }
    fault(rule, rates.size() > 1 ? "the rule has several <rate>; make them one" : null);
    return new Obligations(
        rates.isEmpty() ? null : rate(rates.get(0)),
        has(rule, "log"),
        has(rule, "notify"),
        isConfirmed);
  }

  private static boolean has(Element rule, String obligation) {
    return rule.getChild(obligation, rule.getNamespace()) != null;
  }

  private @Nullable RateLimit rate(Element element) {
    String max = element.getAttributeValue("max");
    String per = element.getAttributeValue("per");
    if (max == null || per == null) {
      isFaulty = true; // the schema's fault
      return null;
    }
    Matcher period = PERIOD.matcher(per);
    if (!max.matches("[0-9]{1,9}") || !period.matches()) {
      fault(
          element,
          "<rate> max " + max + " per " + per + " is no rate; write it as max=\"5\" per=\"1s\"");
      return null;
    }
    try {
      return new RateLimit(Integer.parseInt(max), duration(period));
    } catch (IllegalArgumentException e) {
      fault(element, "<rate>: " + e.getMessage());
      return null;
    }
  }

  private static Duration duration(Matcher period) {
    long count = Long.parseLong(period.group(1));
    return switch (period.group(2)) {
      case "ms" -> Duration.ofMillis(count);
      case "s" -> Duration.ofSeconds(count);
      case "min" -> Duration.ofMinutes(count);
      default -> Duration.ofHours(count);
    };
  }
}
