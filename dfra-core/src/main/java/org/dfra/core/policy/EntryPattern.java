package org.dfra.core.policy;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.core.config.NearestName;
import org.jspecify.annotations.Nullable;

/**
 * Attributes that a rule is about: {@code *} for all, {@code module} for a record, {@code
 * module.host} for one of its components. Records of dfra-api have short names, as in queries: case
 * and underscores do not matter. Others, and entry classes that mirror no record, are named in
 * full.
 *
 * @param type full name of the record or class; empty for all
 * @param component empty for all
 */
record EntryPattern(String type, String component) {

  private static final String ANY = "*";
  private static final String PACKAGE = "org.dfra.persona.";
  private static final String SUFFIX = "Attributes";
  private static final Pattern FULL =
      Pattern.compile("([a-z][\\w]*\\.)+([A-Z][\\w$]*)(\\.([a-z]\\w*))?");
  private static final int MAX_LENGTH = 200;

  /**
   * The records of dfra-api without the suffix, with their components. They are written here since
   * each process reads a policy when it starts, and would load all their classes for it.
   */
  private static final Map<String, List<String>> RECORDS = new TreeMap<>();

  static {
    add("Behavior", "goal script phase rate heldSince");
    add("Camera", "band width height fieldOfView");
    add("Chain", "inputs outputs");
    add("Drive", "maxSpeed maxYawRate length width");
    add("Effector", "commands power preconditions");
    add("EmergencyStop", "latched requester since");
    add("Flight", "autopilot vehicleType maxSpeed maxHeight");
    add("GpsReceiver", "model serialNumber softwarePart softwareVersion channels fixModes");
    add("Location", "latitude longitude height measured");
    add("Module", "robot name driver host author version state created activated clients");
    add("MotorSchema", "command method rules");
    add("PanTilt", "minPan maxPan minTilt maxTilt maxSpeed");
    add("PerceptualSchema", "percept uncertainty method truePositiveRate falsePositiveRate");
    add("Persona", "robot role goals limitations");
    add("Pose", "frame parent x y z roll pitch yaw");
    add("Range", "minRange maxRange fieldOfView resolution accuracy");
    add("Recruitment", "percepts speed strategy replaceAfter margin holdReason");
    add("Sensor", "reading modes minRate maxRate power preconditions");
  }

  private static void add(String name, String components) {
    RECORDS.put(name, List.of(components.split(" ")));
  }

  /** The records of dfra-api by their full names, with their components. */
  static Map<String, List<String>> records() {
    Map<String, List<String>> all = new TreeMap<>();
    RECORDS.forEach((name, components) -> all.put(PACKAGE + name + SUFFIX, components));
    return all;
  }

  /**
   * The attributes that a text names.
   *
   * @throws IllegalArgumentException if it names none; the message says what is wrong
   */
  static EntryPattern of(String text) {
    if (text.equals(ANY)) {
      return new EntryPattern("", "");
    }
    Matcher full = FULL.matcher(text);
    if (text.length() <= MAX_LENGTH && full.matches() && !text.startsWith(PACKAGE)) {
      @Nullable String component = full.group(4);
      return component == null
          ? new EntryPattern(text, "")
          : new EntryPattern(text.substring(0, text.length() - component.length() - 1), component);
    }
    String written = text.startsWith(PACKAGE) ? text.substring(PACKAGE.length()) : text;
    int dot = written.indexOf('.');
    String type = dot < 0 ? written : written.substring(0, dot);
    String name = named(withoutSuffix(type), RECORDS.keySet().stream().toList());
    if (name.isEmpty()) {
      throw new IllegalArgumentException(
          "there are no attributes \""
              + type
              + "\""
              + NearestName.hint(
                  type,
                  RECORDS.keySet().stream().map(EntryPattern::shortName).toList(),
                  "; write a record of dfra-api, such as module, or the full name of another one"));
    }
    String component = dot < 0 ? "" : component(name, written.substring(dot + 1));
    return new EntryPattern(PACKAGE + name + SUFFIX, component);
  }

  private static String component(String record, String written) {
    List<String> components = RECORDS.getOrDefault(record, List.of());
    String name = written.equals(ANY) ? ANY : named(written, components);
    if (name.isEmpty()) {
      throw new IllegalArgumentException(
          "the attributes "
              + shortName(record)
              + " have no component \""
              + written
              + "\""
              + NearestName.hint(
                  written, components, "; they have " + String.join(", ", components)));
    }
    return name.equals(ANY) ? "" : name;
  }

  private static String withoutSuffix(String name) {
    return name.endsWith(SUFFIX) ? name.substring(0, name.length() - SUFFIX.length()) : name;
  }

  /** The one that a name means; empty if none. */
  private static String named(String written, List<String> among) {
    return among.stream().filter(each -> plain(each).equals(plain(written))).findAny().orElse("");
  }

  private static String plain(String name) {
    return name.replace("_", "").toLowerCase(Locale.ROOT);
  }

  /** {@code emergency_stop} of {@code EmergencyStop}. */
  private static String shortName(String record) {
    return record.replaceAll("(?<=[a-z])(?=[A-Z])", "_").toLowerCase(Locale.ROOT);
  }

  /** Whether it is about a component of a record. */
  boolean matches(String ofType, String ofComponent) {
    return type.isEmpty()
        || (type.equals(ofType) && (component.isEmpty() || component.equals(ofComponent)));
  }

  /**
   * Whether it is about a record as a whole.
   *
   * @param isAnyPartEnough whether one of its components is enough
   */
  boolean matchesWhole(String ofType, boolean isAnyPartEnough) {
    return type.isEmpty() || (type.equals(ofType) && (component.isEmpty() || isAnyPartEnough));
  }

  /** As a person writes it. */
  @Override
  public String toString() {
    if (type.isEmpty()) {
      return ANY;
    }
    String name =
        type.startsWith(PACKAGE)
            ? shortName(withoutSuffix(type.substring(PACKAGE.length())))
            : type;
    return component.isEmpty() ? name : name + "." + component;
  }
}
