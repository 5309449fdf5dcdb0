package org.dfra.core.config;

import java.util.List;
import java.util.Map;
import org.jdom2.Namespace;

/** The schema of a robot's XML, {@code robot.xsd} beside this class. */
final class RobotXmlSchema {

  static final XmlSchema ROBOT =
      new XmlSchema("robot", "urn:dfra:robot:1", RobotXmlSchema.class, "robot.xsd");

  /** The namespace of a robot's XML. */
  static final Namespace NAMESPACE = ROBOT.namespace();

  private RobotXmlSchema() {}

  /** All elements with their permitted attributes, in the schema's order. */
  static Map<String, List<String>> attributes() {
    return ROBOT.attributes();
  }
}
