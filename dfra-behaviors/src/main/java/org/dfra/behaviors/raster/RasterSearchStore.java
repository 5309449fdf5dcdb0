package org.dfra.behaviors.raster;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.time.Instant;
import java.time.format.DateTimeParseException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Properties;
import java.util.UUID;
import java.util.stream.Collectors;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.RasterGoal;
import org.dfra.core.behavior.DriveInterlock.LastStop;
import org.dfra.core.state.StateStore;
import org.dfra.core.time.MonotonicTimestamp;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;

/**
 * Persistent state of a search: the goal, the number of finished waypoints, whether it was running,
 * the delegated path, and the last emergency stop of its wheels.
 */
final class RasterSearchStore {

  private static final String DOCUMENT = "raster";
  private static final String NEVER = "never";

  /**
   * A started search.
   *
   * @param goal of the search
   * @param reached number of finished waypoints of its plan
   * @param missed number of skipped ones among those
   * @param phase {@link Phase#RUNNING} or {@link Phase#PAUSED}
   * @param path delegated for it; null where none is
   * @param seen the last emergency stop before it
   */
  record StoredSearch(
      RasterGoal goal,
      int reached,
      int missed,
      Phase phase,
      @Nullable DelegatedPath path,
      LastStop seen) {

    StoredSearch {
      if (missed < 0 || reached < missed || !phase.isUnderWay()) {
        throw new IllegalArgumentException(
            "a stored search has a phase under way and 0 <= skipped <= done waypoints, not "
                + phase
                + ", "
                + missed
                + " skipped of "
                + reached);
      }
    }
  }

  /**
   * A path delegated for the search.
   *
   * @param goal its name
   * @param reached finished waypoints of the plan when it began
   * @param missed number of skipped ones among those
   */
  record DelegatedPath(UUID goal, int reached, int missed) {

    DelegatedPath {
      if (missed < 0 || reached < missed) {
        throw new IllegalArgumentException(
            "a stored path has 0 <= skipped <= done waypoints, not " + missed + " of " + reached);
      }
    }
  }

  private final StateStore state;

  RasterSearchStore(StateStore state) {
    this.state = state;
  }

  void save(StoredSearch begun) throws IOException {
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
    @Nullable DelegatedPath path = begun.path();
    if (path != null) {
      text.setProperty("path", path.goal().toString());
      text.setProperty("path-reached", Integer.toString(path.reached()));
      text.setProperty("path-missed", Integer.toString(path.missed()));
    }
    LastStop seen = begun.seen();
    @Nullable Instant since = seen.since();
    @Nullable MonotonicTimestamp asked = seen.requested();
    if (seen.isKnown()) {
      text.setProperty("stopped", since == null ? NEVER : since.toString());
    } else if (asked != null) {
      text.setProperty("asked-at", asked.toString());
    }
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
   * The search that was started and has not ended.
   *
   * @throws IOException if the stored state cannot be read, or is no search
   */
  Optional<StoredSearch> load() throws IOException {
    Optional<byte[]> kept = state.read(DOCUMENT);
    if (kept.isEmpty()) {
      return Optional.empty();
    }
    Properties text = new Properties();
    try {
      text.load(new ByteArrayInputStream(kept.get()));
      return text.containsKey("region") ? Optional.of(begun(text)) : Optional.empty();
    } catch (IllegalArgumentException e) {
      throw new IOException("the stored search cannot be read: " + e.getMessage(), e);
    }
  }

  private static StoredSearch begun(Properties text) {
    List<GeoPosition> region = new ArrayList<>();
    for (String corner : wanted(text, "region").split(" ")) {
      String[] parts = corner.split(",");
      if (parts.length != 2) {
        throw new IllegalArgumentException("\"" + corner + "\" is not a corner");
      }
      region.add(new GeoPosition(Double.parseDouble(parts[0]), Double.parseDouble(parts[1]), 0));
    }
    return new StoredSearch(
        new RasterGoal(
            region,
            Double.parseDouble(wanted(text, "swath")),
            Double.parseDouble(wanted(text, "spacing")),
            Boolean.parseBoolean(wanted(text, "reversed"))),
        Integer.parseInt(wanted(text, "reached")),
        Integer.parseInt(text.getProperty("missed", "0")), // not stored before 0.2
        Phase.valueOf(wanted(text, "phase")),
        path(text),
        seen(text));
  }

  private static @Nullable DelegatedPath path(Properties text) {
    return text.containsKey("path")
        ? new DelegatedPath(
            UUID.fromString(wanted(text, "path")),
            Integer.parseInt(wanted(text, "path-reached")),
            Integer.parseInt(wanted(text, "path-missed")))
        : null;
  }

  /** Where neither is stored, as before 0.2, any stop counts. */
  private static LastStop seen(Properties text) {
    @Nullable String asked = text.getProperty("asked-at");
    if (asked != null) {
      return LastStop.unknown(MonotonicTimestamp.parse(asked));
    }
    @Nullable String since = text.getProperty("stopped");
    if (since == null) {
      return LastStop.NOTHING;
    }
    try {
      return LastStop.known(since.equals(NEVER) ? null : Instant.parse(since));
    } catch (DateTimeParseException e) {
      throw new IllegalArgumentException("\"" + since + "\" is not a time", e);
    }
  }

  private static String wanted(Properties text, String key) {
    String value = text.getProperty(key);
    if (value == null) {
      throw new IllegalArgumentException("it has no " + key);
    }
    return value;
  }
}
