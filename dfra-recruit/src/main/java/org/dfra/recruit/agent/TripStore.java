package org.dfra.recruit.agent;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.UUID;
import org.dfra.core.module.ModuleContext;
import org.slf4j.Logger;

/** Persistent state of a {@link WaypointTrip}. Confined to the task thread. */
final class TripStore {

  private static final String DOCUMENT = "trip";

  /**
   * A started leg.
   *
   * @param goal its name
   * @param place target, as text
   * @param stops emergency stops at the time of the request
   */
  record StartedLeg(UUID goal, String place, EmergencyStopSnapshot stops) {

    private static StartedLeg of(String text) {
      String[] lines = text.split("\n", 3);
      return new StartedLeg(
          UUID.fromString(lines[0]),
          lines.length > 1 ? lines[1] : "",
          EmergencyStopSnapshot.parse(lines.length > 2 ? lines[2] : ""));
    }

    private String text() {
      return goal + "\n" + place + "\n" + stops.text();
    }
  }

  private final ModuleContext context;
  private final Logger log;
  private boolean isKept; // that one was started

  TripStore(ModuleContext context, Logger log) {
    this.context = context;
    this.log = log;
  }

  /** The leg started by an earlier process; empty where it had ended or is unknown. */
  Optional<StartedLeg> load() {
    try {
      byte[] kept = context.state().read(DOCUMENT).orElse(new byte[0]);
      if (kept.length > 0) {
        StartedLeg begun = StartedLeg.of(new String(kept, StandardCharsets.UTF_8));
        isKept = true;
        return Optional.of(begun);
      }
    } catch (IOException | IllegalArgumentException e) {
      log.warn("{}: the stored trip cannot be read: {}", context.path(), e.toString());
    }
    return Optional.empty();
  }

  void save(StartedLeg begun) {
    write(begun.text());
  }

  /** Removes the ended leg. */
  void forget() {
    if (isKept) {
      write("");
    }
  }

  private void write(String text) {
    try {
      context.state().write(DOCUMENT, text.getBytes(StandardCharsets.UTF_8));
      isKept = !text.isEmpty();
    } catch (IOException e) {
      log.warn(
          "{}: the trip cannot be stored, so it is lost after a restart: {}",
          context.path(),
          e.toString());
    }
  }
}
