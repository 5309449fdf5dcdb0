package org.dfra.behaviors.raster;

import java.nio.file.Path;
import java.util.List;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.core.config.ConfigurationFaults;
import org.dfra.core.geojson.GeoJsonFeature;
import org.dfra.core.geojson.GeoJsonFile;
import org.dfra.geometry.GeoPosition;

/**
 * A region in a GeoJSON file (RFC 7946): a bare Polygon, a Feature, or a FeatureCollection with one
 * polygon that has the property {@code "kind": "region"}, or with one polygon in all. So the file
 * of a world works as well: its obstacles and posts are ignored.
 */
public final class RegionFile {

  private RegionFile() {}

  /**
   * The region of a file.
   *
   * @throws org.dfra.core.config.ConfigurationException if it contains none or more than one, or an
   *     invalid one; each line of the message names file and line
   */
  public static Region read(Path path) {
    ConfigurationFaults faults = new ConfigurationFaults();
    GeoJsonFile file = GeoJsonFile.read(path, faults);
    faults.throwIfAny();
    List<GeoJsonFeature> polygons =
        file.features().stream().filter(each -> each.type().equals("Polygon")).toList();
    List<GeoJsonFeature> named = polygons.stream().filter(RegionFile::isRegion).toList();
    List<GeoJsonFeature> meant = named.isEmpty() ? polygons : named;
    if (meant.size() != 1) {
      complain(file, polygons, meant, faults);
    } else {
      GeoJsonFeature feature = meant.get(0);
      try {
        List<GeoPosition> ring = feature.ring(faults).orElse(List.of());
        faults.throwIfAny();
        return Region.of(ring);
      } catch (GoalRefusedException e) {
        faults.add(feature.place(), String.valueOf(e.getMessage()));
      }
    }
    faults.throwIfAny();
    throw new IllegalStateException("a region was neither read nor refused: " + path);
  }

  private static boolean isRegion(GeoJsonFeature feature) {
    return feature.properties().path("kind").asText().equals("region");
  }

  private static void complain(
      GeoJsonFile file,
      List<GeoJsonFeature> polygons,
      List<GeoJsonFeature> meant,
      ConfigurationFaults faults) {
    if (polygons.isEmpty()) {
      faults.add(
          file.place(),
          "it contains no polygon (its type is "
              + file.type()
              + "); write a Polygon, or a Feature or FeatureCollection that contains one");
    } else if (isRegion(meant.get(0))) {
      meant.stream()
          .skip(1)
          .forEach(each -> faults.add(each.place(), "there is a second region; delete one"));
    } else {
      faults.add(
          file.place(),
          "it has "
              + polygons.size()
              + " polygons, and none is marked as the region; write \"kind\": \"region\" in the"
              + " properties of one");
    }
  }
}
