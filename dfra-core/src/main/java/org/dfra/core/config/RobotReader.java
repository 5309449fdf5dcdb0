package org.dfra.core.config;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dfra.core.config.RobotDescription.AdministrationDescription;
import org.dfra.core.config.RobotDescription.GroupDescription;
import org.dfra.core.config.RobotXml.RobotXmlSchema;
import org.dfra.persona.PersonaAttributes;
import org.jdom2.Element;
import org.jspecify.annotations.Nullable;

/**
 * Reads one robot's XML. The schema validation finds some faults; this class records all others and
 * continues reading, so that all are reported at once.
 */
final class RobotReader {

  /** The child elements of a robot other than groups. */
  private static final Set<String> OTHERS = Set.of("lookup", "administration", "persona");

  private final Path file;
  private final ConfigurationFaults faults;
  private final XmlValues values;
  private final Substitution substitution;
  private final XmlValues.UniqueNames groupNames;
  private final XmlValues.UniqueNames moduleNames;
  private final XmlValues.UniqueNames singles;

  RobotReader(Path file, Substitution substitution, ConfigurationFaults faults) {
    this.file = file;
    this.substitution = substitution;
    this.faults = faults;
    this.values = new XmlValues(file.toString(), substitution, faults);
    this.groupNames = values.uniqueNames();
    this.moduleNames = values.uniqueNames();
    this.singles = values.uniqueNames();
  }

  /** The robot; empty, with the reasons among the faults, if it has any. */
  Optional<RobotDescription> robot(Element root) {
    String name = values.name(root);
    String host = values.attribute(root, "host", "auto");
    values.check(root, host == null ? null : DescriptionRules.host(host));
    List<String> lookupGroups = new ArrayList<>();
    List<String> locators = new ArrayList<>();
    List<GroupDescription> groups = new ArrayList<>();
    for (Element lookup : children(root, "lookup")) {
      singles.requireFirst(lookup, "lookup", "<lookup>", "make them one");
      lookupGroups.addAll(list(lookup, "groups"));
      locators.addAll(list(lookup, "locators"));
      locators.forEach(locator -> values.check(lookup, DescriptionRules.locator(locator)));
    }
    AdministrationDescription administration = AdministrationDescription.LOCAL;
    for (Element child : children(root, "administration")) {
      singles.requireFirst(child, "administration", "<administration>", "make them one");
      administration = administration(child);
    }
    Optional<PersonaAttributes> persona = Optional.empty();
    for (Element child : children(root, "persona")) {
      singles.requireFirst(child, "persona", "<persona>", "make them one");
      persona = persona(child, name);
    }
    for (Element group : children(root, "group")) {
      group(group, name).ifPresent(groups::add);
    }
    if (root.getChildren().stream().allMatch(child -> OTHERS.contains(child.getName()))) {
      values.check(root, "the robot has no group; add a <group>, since a group runs its modules");
    }
    return faults.isEmpty() && name != null && host != null
        ? Optional.of(
            new RobotDescription(
                name, host, lookupGroups, locators, administration, persona, groups, file))
        : Optional.empty();
  }

  private AdministrationDescription administration(Element element) {
    return new AdministrationDescription(
        hosts(element, "from", DescriptionRules::administrator), values.place(element));
  }

  /** Returns the fault of a text; null if there is none. */
  private interface Rule {
    @Nullable String fault(String text);
  }

  /** The addresses from which an element accepts calls; invalid ones are omitted. */
  private List<String> hosts(Element element, String attribute, Rule rule) {
    List<String> right = new ArrayList<>();
    for (String each : list(element, attribute)) {
      @Nullable String fault = rule.fault(each);
      values.check(element, fault);
      if (fault == null) {
        right.add(each);
      }
    }
    return right;
  }

  private Optional<PersonaAttributes> persona(Element element, @Nullable String robot) {
    String role = values.attribute(element, "role", "");
    List<String> goals = sentences(element, "goal");
    List<String> limitations = sentences(element, "limitation");
    return role == null || robot == null || robot.isBlank()
        ? Optional.empty()
        : Optional.of(new PersonaAttributes(robot, role.strip(), goals, limitations));
  }

  private List<String> sentences(Element element, String kind) {
    List<String> sentences = new ArrayList<>();
    for (Element child : children(element, kind)) {
      String text = values.text(child);
      if (text != null && text.isEmpty()) {
        values.check(child, "the " + kind + " is empty; write a sentence, or delete it");
      } else if (text != null) {
        sentences.add(text);
      }
    }
    return sentences;
  }

  private Optional<GroupDescription> group(Element element, @Nullable String robot) {
    String name = values.name(element);
    if (name != null) {
      groupNames.requireFirst(element, name, "group " + name, "rename one, or make them one");
    }
    List<String> options = new ArrayList<>();
    for (Element option : children(element, "jvm-option")) {
      String text = values.text(option);
      if (text != null && text.isEmpty()) {
        values.check(option, "the JVM option is empty; write one, such as -Xmx64m, or delete it");
      } else if (text != null) {
        options.add(text);
      }
    }
    Optional<RegistrarDescription> registrar = Optional.empty();
    for (Element child : children(element, "registrar")) {
      singles.requireFirst(
          child, "registrar", "<registrar>", "a robot has one at most, so delete one");
      registrar = registrar(child);
    }
    List<ModuleDescription> modules = new ArrayList<>();
    for (Element module : children(element, "module")) {
      ModuleReader reader = new ModuleReader(file, module, values, substitution, faults);
      String moduleName = reader.name();
      if (moduleName != null) {
        moduleNames.requireFirst(
            module, moduleName, "module " + moduleName, "rename one, in whichever group it is");
      }
      reader.module(robot).ifPresent(modules::add);
    }
    return faults.isEmpty() && name != null
        ? Optional.of(
            new GroupDescription(name, options, registrar, modules, values.place(element)))
        : Optional.empty();
  }

  private Optional<RegistrarDescription> registrar(Element element) {
    String port =
        values.attribute(element, "port", Integer.toString(RegistrarDescription.DEFAULT_PORT));
    String fault = port == null ? null : DescriptionRules.registrarPort(port);
    values.check(element, fault);
    Integer classServerPort = classServerPort(element);
    boolean restart = values.restart(element);
    List<String> moduleHosts = hosts(element, "module-hosts", DescriptionRules::moduleHost);
    return port == null || fault != null || classServerPort == null
        ? Optional.empty()
        : Optional.of(
            new RegistrarDescription(
                Integer.parseInt(port),
                classServerPort,
                restart,
                moduleHosts,
                values.place(element)));
  }

  /** The class server's port; null, with a fault, if it is invalid. */
  private @Nullable Integer classServerPort(Element element) {
    String written =
        values.attribute(
            element,
            "class-server-port",
            Integer.toString(RegistrarDescription.DEFAULT_CLASS_SERVER_PORT));
    if (written == null || written.equals(RegistrarDescription.OFF)) {
      return written == null ? null : RegistrarDescription.NO_CLASS_SERVER;
    }
    String fault = DescriptionRules.classServerPort(written);
    values.check(element, fault);
    return fault == null ? Integer.valueOf(written) : null;
  }

  /** The items between the commas of an attribute; blank items are omitted. */
  private List<String> list(Element element, String attribute) {
    String text = values.attribute(element, attribute, "");
    return text == null
        ? List.of()
        : Arrays.stream(text.split(","))
            .map(String::strip)
            .filter(item -> !item.isEmpty())
            .distinct()
            .toList();
  }

  private static List<Element> children(Element element, String name) {
    return element.getChildren(name, RobotXmlSchema.NAMESPACE);
  }
}
