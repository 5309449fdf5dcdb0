package org.dfra.core.geojson;

import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dfra.core.config.ConfigurationFaults;
import org.dfra.core.config.SourceFile;
import org.dfra.core.config.SourceLocation;

/**
 * The content of a GeoJSON file.
 *
 * @param place the file as a whole
 * @param type the type of its root, such as FeatureCollection; {@code none} if it has no type, or
 *     is a FeatureCollection without features; {@code nothing} if it is not JSON
 * @param features the features of a FeatureCollection; of a Feature or a bare geometry that one;
 *     otherwise empty
 */
public record GeoJsonFile(SourceLocation place, String type, List<GeoJsonFeature> features) {

  /** The type of a root with several features. */
  public static final String COLLECTION = "FeatureCollection";

  /** The type of a file that is not JSON; the fault is recorded. */
  private static final String BROKEN = "nothing";

  private static final JsonMapper MAPPER = new JsonMapper();

  public GeoJsonFile {
    features = List.copyOf(features);
  }

  /**
   * Reads a file. Invalid JSON is recorded as a fault with its line; the features before it are
   * returned.
   *
   * @throws org.dfra.core.config.ConfigurationException if it does not exist or cannot be read
   */
  public static GeoJsonFile read(Path file, ConfigurationFaults faults) {
    return new Reading(file.toString(), faults).read(SourceFile.readBytes(file, "a GeoJSON file"));
  }

  /** Whether its root is a FeatureCollection that has features, or at least their empty array. */
  public boolean isCollection() {
    return type.equals(COLLECTION);
  }

  /**
   * Whether it is not a JSON object; the fault is recorded, and features before it are returned.
   */
  public boolean isBroken() {
    return type.equals(BROKEN);
  }

  private static final class Reading {

    private final String file;
    private final ConfigurationFaults faults;
    private final List<GeoJsonFeature> features = new ArrayList<>();
    private final ObjectNode others = MAPPER.createObjectNode(); // the root's other members
    private boolean hasFeatures;

    Reading(String file, ConfigurationFaults faults) {
      this.file = file;
      this.faults = faults;
    }

    GeoJsonFile read(byte[] text) {
      int line = 1;
      try (JsonParser parser = MAPPER.createParser(text)) {
        if (parser.nextToken() != JsonToken.START_OBJECT) {
          faults.add(place(1), "this is not a JSON object; write a FeatureCollection of GeoJSON");
          return result(BROKEN, 1);
        }
        line = parser.currentTokenLocation().getLineNr();
        while (parser.nextToken() != JsonToken.END_OBJECT) {
          member(parser);
        }
      } catch (JsonProcessingException e) {
        int at = e.getLocation() == null ? 0 : Math.max(0, e.getLocation().getLineNr());
        faults.add(place(at), "this is not JSON (" + e.getOriginalMessage() + "); correct it here");
        return result(BROKEN, line);
      } catch (IOException e) {
        throw new IllegalStateException("bytes in memory cannot be read", e);
      }
      return result(others.path("type").asText("none"), line);
    }

    private void member(JsonParser parser) throws IOException {
      String name = parser.currentName();
      if (parser.nextToken() != JsonToken.START_ARRAY || !name.equals("features")) {
        JsonNode before = others.replace(name, MAPPER.readTree(parser));
        if (before != null) {
          faults.add(place(0), "its member " + name + " is there twice; delete one");
        }
        return;
      }
      hasFeatures = true;
      while (parser.nextToken() != JsonToken.END_ARRAY) {
        SourceLocation place = place(parser.currentTokenLocation().getLineNr());
        JsonNode feature = MAPPER.readTree(parser);
        features.add(
            new GeoJsonFeature(place, feature.path("properties"), feature.path("geometry")));
      }
    }

    private GeoJsonFile result(String type, int line) {
      SourceLocation place = place(line);
      if (type.equals(BROKEN) || type.equals(COLLECTION) && hasFeatures) {
        return new GeoJsonFile(place(0), type, features);
      }
      if (type.equals("Feature")) {
        return new GeoJsonFile(
            place(0),
            type,
            List.of(new GeoJsonFeature(place, others.path("properties"), others.path("geometry"))));
      }
      if (others.has("coordinates")) {
        return new GeoJsonFile(
            place(0), type, List.of(new GeoJsonFeature(place, MAPPER.createObjectNode(), others)));
      }
      return new GeoJsonFile(place(0), type.equals(COLLECTION) ? "none" : type, List.of());
    }

    private SourceLocation place(int line) {
      return new SourceLocation(file, line);
    }
  }
}
