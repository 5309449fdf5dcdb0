package org.dfra.sim.world.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Function;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.ConfigurationFaults;
import org.dfra.core.config.SourceFile;
import org.dfra.core.config.SourceLocation;
import org.dfra.core.config.Substitution;
import org.dfra.core.config.XmlSchema;
import org.dfra.sim.world.description.WorldDescription;
import org.jdom2.Element;
import org.jspecify.annotations.Nullable;

/**
 * Reads and writes worlds. The XML's reference is {@code docs/reference/world-xml.md}, its schema
 * {@code world.xsd}.
 */
public final class WorldXml {

  static final XmlSchema SCHEMA =
      new XmlSchema("world", "urn:dfra:world:1", WorldXml.class, "world.xsd");

  private WorldXml() {}

  /**
   * Reads a world's XML and the GeoJSON it names; variables come from system properties, otherwise
   * from the environment.
   *
   * @throws ConfigurationException naming all errors, a line each
   */
  public static WorldDescription read(Path file) {
    return read(file, Substitution::environment);
  }

  /**
   * Reads a world's XML and the GeoJSON it names.
   *
   * @param lookup gives the value of a variable, or null where it is not set
   * @throws ConfigurationException naming all errors, a line each
   */
  public static WorldDescription read(Path file, Function<String, @Nullable String> lookup) {
    ConfigurationFaults faults = new ConfigurationFaults();
    byte[] text = SourceFile.readBytes(file, "the XML file of a world");
    Element root = SCHEMA.read(text, new SourceLocation(file.toString(), 0), faults);
    Optional<WorldDescription> world =
        new WorldReader(file, new Substitution(lookup, faults), faults).world(root);
    faults.throwIfAny();
    return world.orElseThrow();
  }

  /**
   * The world as XML that needs neither variables nor GeoJSON: reading it gives an equal
   * description, except for the source locations.
   */
  public static String text(WorldDescription world) {
    return WorldWriter.text(world);
  }

  /**
   * Writes {@link #text} to a file, replacing its content.
   *
   * @throws IOException if it cannot be written
   */
  public static void write(WorldDescription world, Path file) throws IOException {
    Files.writeString(file, text(world));
  }
}
