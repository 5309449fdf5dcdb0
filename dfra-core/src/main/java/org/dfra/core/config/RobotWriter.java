package org.dfra.core.config;

import org.dfra.core.config.RobotDescription.GroupDescription;
import org.dfra.core.config.RobotXml.RobotXmlSchema;
import org.dfra.persona.PersonaAttributes;
import org.jdom2.Document;
import org.jdom2.Element;
import org.jdom2.IllegalDataException;
import org.jdom2.output.Format;
import org.jdom2.output.LineSeparator;
import org.jdom2.output.XMLOutputter;
import org.jspecify.annotations.Nullable;

/** Writes a robot as XML with all variables and properties resolved. */
final class RobotWriter {

  private RobotWriter() {}

  static String toXml(RobotDescription robot) {
    Element root = element("robot");
    set(root, "name", robot.name());
    set(root, "host", robot.host());
    Element lookup = element("lookup");
    set(lookup, "groups", String.join(",", robot.lookupGroups()));
    set(lookup, "locators", String.join(",", robot.locators()));
    root.addContent(lookup);
    if (!robot.administration().administratorHosts().isEmpty()) {
      Element administration = element("administration");
      set(administration, "from", String.join(",", robot.administration().administratorHosts()));
      root.addContent(administration);
    }
    robot.persona().ifPresent(persona -> root.addContent(persona(persona)));
    robot.groups().forEach(group -> root.addContent(group(group)));
    Format format = Format.getPrettyFormat().setLineSeparator(LineSeparator.UNIX);
    return new XMLOutputter(format).outputString(new Document(root));
  }

  private static Element persona(PersonaAttributes persona) {
    Element element = element("persona");
    set(element, "role", persona.role());
    for (String goal : persona.goals()) {
      element.addContent(element("goal").setText(Substitution.escape(goal)));
    }
    for (String limitation : persona.limitations()) {
      element.addContent(element("limitation").setText(Substitution.escape(limitation)));
    }
    return element;
  }

  private static Element group(GroupDescription group) {
    Element element = element("group");
    set(element, "name", group.name());
    for (String option : group.jvmOptions()) {
      element.addContent(element("jvm-option").setText(Substitution.escape(option)));
    }
    group.registrar().ifPresent(registrar -> element.addContent(registrar(registrar)));
    group.modules().forEach(module -> element.addContent(module(module)));
    return element;
  }

  private static Element registrar(RegistrarDescription registrar) {
    Element element = element("registrar");
    set(element, "port", Integer.toString(registrar.port()));
    set(
        element,
        "class-server-port",
        registrar.hasClassServer()
            ? Integer.toString(registrar.classServerPort())
            : RegistrarDescription.OFF);
    set(element, "restart", Boolean.toString(registrar.restart()));
    if (!registrar.moduleHosts().isEmpty()) {
      set(element, "module-hosts", String.join(",", registrar.moduleHosts()));
    }
    return element;
  }

  private static Element module(ModuleDescription module) {
    Element element = element("module");
    set(element, "name", module.name());
    set(element, ModuleProperties.SERVER, module.serverClass());
    set(element, ModuleProperties.PROXY, module.proxyClass());
    set(element, ModuleProperties.IMPLEMENTATION, module.driverClass());
    set(element, ModuleProperties.CONFIGURATION, module.configuration());
    if (!module.codebase().isEmpty()) {
      set(element, ModuleProperties.CODEBASE, String.join(",", module.codebase()));
    }
    set(element, "restart", Boolean.toString(module.restart()));
    module
        .parameters()
        .all()
        .forEach((name, value) -> element.addContent(parameter(module, name, value)));
    return element;
  }

  private static Element parameter(ModuleDescription module, String name, Parameters.Value value) {
    Element element = element("parameter");
    try {
      set(element, "name", name);
      set(element, "value", value.text());
    } catch (IllegalDataException e) {
      throw new ConfigurationException(
          value.place()
              + ": parameter "
              + name
              + " of "
              + module.path()
              + " holds a character that XML cannot write; leave it out",
          e);
    }
    return element;
  }

  private static Element element(String name) {
    return new Element(name, RobotXmlSchema.NAMESPACE);
  }

  private static void set(Element element, String name, @Nullable String value) {
    if (value != null) {
      element.setAttribute(name, Substitution.escape(value));
    }
  }
}
