package org.dfra.core.config;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.jdom2.Element;
import org.jdom2.Namespace;
import org.jspecify.annotations.Nullable;

/**
 * Reads and writes robots. The XML's reference is {@code docs/reference/robot-xml.md}, its schema
 * {@code robot.xsd}.
 */
public final class RobotXml {

  private RobotXml() {}

  /**
   * Reads a robot's XML and the properties of its modules; variables come from system properties or
   * else from the environment.
   *
   * @throws ConfigurationException with every fault in them, a line each
   */
  public static RobotDescription read(Path file) {
    return read(file, Substitution::environment);
  }

  /**
   * Reads a robot's XML and the properties of its modules.
   *
   * @param lookup returns the value of a variable, or null if it is not set
   * @throws ConfigurationException with every fault in them, a line each
   */
  public static RobotDescription read(Path file, Function<String, @Nullable String> lookup) {
    ConfigurationFaults faults = new ConfigurationFaults();
    byte[] text = SourceFile.readBytes(file, "the XML file of a robot");
    Element root = RobotXmlSchema.ROBOT.read(text, new SourceLocation(file.toString(), 0), faults);
    Optional<RobotDescription> robot =
        new RobotReader(file, new Substitution(lookup, faults), faults).robot(root);
    faults.throwIfAny();
    return robot.orElseThrow();
  }

  /**
   * The robot as XML that needs neither variables nor properties files: reading it gives an equal
   * description, apart from the places.
   *
   * @throws ConfigurationException if a text contains a character that XML cannot represent
   */
  public static String toXml(RobotDescription robot) {
    return RobotWriter.toXml(robot);
  }

  /**
   * Writes {@link #toXml} to a file, replacing its content, and a mark that it need not be
   * validated when it is read.
   *
   * @throws IOException if it cannot be written
   */
  public static void write(RobotDescription robot, Path file) throws IOException {
    Files.writeString(file, RobotXmlSchema.ROBOT.marked(toXml(robot)));
  }

  /** The schema of a robot's XML, {@code robot.xsd} beside this class. */
  static final class RobotXmlSchema {

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
}
