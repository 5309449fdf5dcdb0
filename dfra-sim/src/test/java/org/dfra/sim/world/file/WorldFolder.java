package org.dfra.sim.world.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dfra.core.config.ConfigurationException;
import org.dfra.sim.world.description.WorldDescription;

/** A folder with a world's XML and one GeoJSON file, as the tests want them. */
final class WorldFolder {

  private static final String ROOT =
      "<world xmlns=\"urn:dfra:world:1\" name=\"field\">"
          + "<datum latitude=\"48\" longitude=\"11\"/><ground size_east=\"60\" size_north=\"40\"/>\n";

  private final Path folder;

  WorldFolder(Path folder) {
    this.folder = folder;
  }

  /** Writes {@code world.xml}: root, datum and ground in line 1, the given lines from line 2. */
  WorldFolder xml(String... lines) {
    return document(ROOT + String.join("\n", lines) + "\n</world>\n");
  }

  /** Writes {@code world.xml}. */
  WorldFolder document(String text) {
    write("world.xml", text);
    return this;
  }

  /** Writes {@code things.geojson} with a feature per line from line 2, and XML that names it. */
  WorldFolder features(String... features) {
    write(
        "things.geojson",
        "{\"type\": \"FeatureCollection\", \"features\": [\n"
            + String.join(",\n", features)
            + "]}\n");
    return xml("<features href=\"things.geojson\"/>");
  }

  /** Writes {@code things.geojson}, and XML that names it. */
  WorldFolder geoJson(String text) {
    write("things.geojson", text);
    return xml("<features href=\"things.geojson\"/>");
  }

  /** A feature of GeoJSON. */
  static String feature(String geometry, String coordinates, String properties) {
    return "{\"type\": \"Feature\", \"geometry\": {\"type\": \""
        + geometry
        + "\", \"coordinates\": "
        + coordinates
        + "}, \"properties\": {"
        + properties
        + "}}";
  }

  Path path(String name) {
    return folder.resolve(name);
  }

  WorldDescription read() {
    return WorldXml.read(path("world.xml"), name -> null);
  }

  /** The complaint's lines, without the folder's path. */
  List<String> complaints() {
    ConfigurationException complaint =
        catchThrowableOfType(ConfigurationException.class, this::read);
    assertThat(complaint).as("a world that cannot be used was read").isNotNull();
    return complaint.getMessage().lines().map(line -> line.replace(folder + "/", "")).toList();
  }

  void write(String name, String text) {
    try {
      Files.writeString(path(name), text);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }
}
