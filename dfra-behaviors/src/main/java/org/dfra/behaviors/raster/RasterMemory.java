package org.dfra.behaviors.raster;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Properties;
import java.util.stream.Collectors;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.RasterGoal;
import org.dfra.core.state.StateStore;
import org.dfra.geometry.GeoPosition;

/**
 * What of a search outlives its process: the goal, how many of its waypoints are done, and whether
 * it was at work.
 */
final class RasterMemory {

  private static final String DOCUMENT = "raster";

  /**
   * A search that was begun.
   *
   * @param goal what it is to reach
   * @param reached how many waypoints of its plan are done
   * @param missed how many of those were left out
   * @param phase {@link Phase#RUNNING} or {@link Phase#PAUSED}
   */
  record Begun(RasterGoal goal, int reached, int missed, Phase phase) {

    Begun {
      if (missed < 0 || reached < missed || !phase.isUnderWay()) {
        throw new IllegalArgumentException(
            "a search that is "
                + phase
                + " with "
                + reached
                + " waypoints done and "
                + missed
                + " of them left out is none");
      }
    }
  }

  private final StateStore state;

  RasterMemory(StateStore state) {
    this.state = state;
  }

  void keep(Begun begun) throws IOException {
    Properties text = new Properties();
    text.setProperty(
        "region",
        begun.goal().region().stream()
            .map(corner -> corner.latitude() + "," + corner.longitude())
            .collect(Collectors.joining(" ")));
    text.setProperty("swath", Double.toString(begun.goal().swath()));
    text.setProperty("spacing", Double.toString(begun.goal().spacing()));
    text.setProperty("reversed", Boolean.toString(begun.goal().reversed()));
    text.setProperty("reached", Integer.toString(begun.reached()));
    text.setProperty("missed", Integer.toString(begun.missed()));
    text.setProperty("phase", begun.phase().name());
    write(text);
  }

  void forget() throws IOException {
    write(new Properties());
  }

  private void write(Properties text) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    text.store(bytes, null);
    state.write(DOCUMENT, bytes.toByteArray());
  }

  /**
   * The search that was begun and not ended.
   *
   * @throws IOException if what was kept cannot be read, or is no search
   */
  Optional<Begun> recall() throws IOException {
    Optional<byte[]> kept = state.read(DOCUMENT);
    if (kept.isEmpty()) {
      return Optional.empty();
    }
    Properties text = new Properties();
    try {
      text.load(new ByteArrayInputStream(kept.get()));
      return text.containsKey("region") ? Optional.of(begun(text)) : Optional.empty();
    } catch (IllegalArgumentException e) {
      throw new IOException("the search that was begun cannot be read: " + e.getMessage(), e);
    }
  }

  private static Begun begun(Properties text) {
    List<GeoPosition> region = new ArrayList<>();
    for (String corner : wanted(text, "region").split(" ")) {
      String[] parts = corner.split(",");
      if (parts.length != 2) {
        throw new IllegalArgumentException("\"" + corner + "\" is no corner");
      }
      region.add(new GeoPosition(Double.parseDouble(parts[0]), Double.parseDouble(parts[1]), 0));
    }
    return new Begun(
        new RasterGoal(
            region,
            Double.parseDouble(wanted(text, "swath")),
            Double.parseDouble(wanted(text, "spacing")),
            Boolean.parseBoolean(wanted(text, "reversed"))),
        Integer.parseInt(wanted(text, "reached")),
        Integer.parseInt(text.getProperty("missed", "0")), // kept by nobody before 0.2
        Phase.valueOf(wanted(text, "phase")));
  }

  private static String wanted(Properties text, String key) {
    String value = text.getProperty(key);
    if (value == null) {
      throw new IllegalArgumentException("it has no " + key);
    }
    return value;
  }
}
