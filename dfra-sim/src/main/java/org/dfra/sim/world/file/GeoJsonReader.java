package org.dfra.sim.world.file;

import java.nio.file.Path;
import org.dfra.core.config.ConfigurationFaults;
import org.dfra.core.geojson.GeoJsonFeature;
import org.dfra.core.geojson.GeoJsonFile;
import org.dfra.geometry.LocalFrame;

/**
 * One reading of one GeoJSON file: a FeatureCollection whose polygons are obstacles or the region,
 * whose points are posts or mines, by the property {@code kind}. Errors are recorded with the line
 * in which the feature begins.
 */
final class GeoJsonReader {

  private final Path file;
  private final LocalFrame frame;
  private final WorldObjectCollector things;
  private final ConfigurationFaults faults;

  GeoJsonReader(
      Path file, LocalFrame frame, WorldObjectCollector things, ConfigurationFaults faults) {
    this.file = file;
    this.frame = frame;
    this.things = things;
    this.faults = faults;
  }

  void read() {
    GeoJsonFile read = GeoJsonFile.read(file, faults);
    if (!read.isCollection() && !read.isBroken()) {
      faults.add(
          read.place(),
          "its type is "
              + read.type()
              + "; write a FeatureCollection with an array of features, {\"type\":"
              + " \"FeatureCollection\", \"features\": […]}");
      return;
    }
    for (GeoJsonFeature feature : read.features()) {
      new GeoFeature(feature, frame, things, faults).read();
    }
  }
}
