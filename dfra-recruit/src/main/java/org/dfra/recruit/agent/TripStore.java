package org.dfra.recruit.agent;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.UUID;
import org.dfra.core.module.ModuleContext;
import org.slf4j.Logger;

/** What of a {@link Trip} outlives its agent's process. Confined to the thread of the errands. */
final class TripStore {

  private static final String DOCUMENT = "trip";

  /**
   * A leg that was begun.
   *
   * @param goal its name
   * @param place where to, as text
   * @param stops the emergency stops that there had been when the agent was asked to go there
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
  private boolean isKept; // that one was begun

  TripStore(ModuleContext context, Logger log) {
    this.context = context;
    this.log = log;
  }

  /** What an earlier process has begun; nothing where it had ended, or nobody knows. */
  Optional<StartedLeg> load() {
    try {
      byte[] kept = context.state().read(DOCUMENT).orElse(new byte[0]);
      if (kept.length > 0) {
        StartedLeg begun = StartedLeg.of(new String(kept, StandardCharsets.UTF_8));
        isKept = true;
        return Optional.of(begun);
      }
    } catch (IOException | IllegalArgumentException e) {
      log.warn("{}: it does not know where it was going: {}", context.path(), e.toString());
    }
    return Optional.empty();
  }

  void save(StartedLeg begun) {
    write(begun.text());
  }

  /** It has ended. */
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
          "{}: its next process would not know where it is going: {}",
          context.path(),
          e.toString());
    }
  }
}
