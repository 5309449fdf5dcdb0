package org.dfra.sim.world.file;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dfra.core.config.ConfigurationFaults;
import org.dfra.core.config.SourceLocation;
import org.dfra.sim.world.description.WorldDescription.MineDescription;
import org.dfra.sim.world.description.WorldDescription.ObstacleDescription;
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.jspecify.annotations.Nullable;

/** Collects the objects of a world from its XML and its GeoJSON. */
final class WorldObjectCollector {

  /** Of a post, metres. */
  static final double POST_RADIUS = 0.05;

  /** Of posts and other obstacles, metres. */
  static final double HEIGHT = 1.5;

  private final List<ObstacleDescription> obstacles = new ArrayList<>();
  private final List<MineDescription> mines = new ArrayList<>();
  private final Map<String, Integer> counts = new HashMap<>();
  private @Nullable Polygon region;

  /** The name given, or the kind with a running number, as in {@code post_3}. */
  String name(String kind, @Nullable String given) {
    int number = counts.merge(kind, 1, Integer::sum);
    return given == null ? kind + "_" + number : given;
  }

  void add(ObstacleDescription obstacle) {
    obstacles.add(obstacle);
  }

  void add(MineDescription mine) {
    mines.add(mine);
  }

  void region(Polygon polygon, SourceLocation place, ConfigurationFaults faults) {
    if (region != null) {
      faults.add(place, "there is a second region; delete one");
    }
    region = polygon;
  }

  List<ObstacleDescription> obstacles() {
    return obstacles;
  }

  List<MineDescription> mines() {
    return mines;
  }

  Optional<Polygon> region() {
    return Optional.ofNullable(region);
  }
}
