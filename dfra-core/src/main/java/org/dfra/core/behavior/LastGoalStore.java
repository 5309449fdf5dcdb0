package org.dfra.core.behavior;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.time.InstantSource;
import java.time.format.DateTimeParseException;
import java.util.Objects;
import java.util.Optional;
import java.util.UUID;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.core.state.StateStore;
import org.jspecify.annotations.Nullable;

/**
 * Stores the state of a behaviour's last goal across restarts: its identity, its phase, and whether
 * it is held. So a client can distinguish, after the process has died, a lost goal from a stopped
 * one. This fails if the process dies in the milliseconds between the stop and the write; then the
 * caller that stopped the goal gets no answer.
 *
 * <p>Not thread-safe, except for the requester.
 */
final class LastGoalStore {

  private static final String DOCUMENT = "last-goal";
  private static final String REQUESTER = "goal-requester";
  private static final String NOT_HELD = "-";

  private final StateStore state;
  private @Nullable BehaviorStatus kept;
  private volatile String requester = "";

  LastGoalStore(StateStore state) {
    this.state = state;
  }

  /**
   * Saves the status if the next process needs it.
   *
   * @throws IOException if it cannot be written; the previous state is then kept
   */
  void save(BehaviorStatus status) throws IOException {
    @Nullable BehaviorStatus last = kept;
    boolean isKept =
        last != null
            && Objects.equals(status.goal(), last.goal())
            && status.phase() == last.phase()
            && Objects.equals(status.heldSince(), last.heldSince());
    if (isKept || status.goal() == null) {
      return;
    }
    @Nullable Instant held = status.heldSince();
    String text =
        String.join(
            "\n",
            status.goal().toString(),
            status.phase().name(),
            held == null ? NOT_HELD : held.toString(),
            status.activity());
    state.write(DOCUMENT, text.getBytes(StandardCharsets.UTF_8));
    kept = status;
  }

  /**
   * The state of the earlier process' goal; empty if there was none.
   *
   * @throws IOException if it cannot be read
   */
  Optional<BehaviorStatus> load(InstantSource clock) throws IOException {
    Optional<byte[]> bytes = state.read(DOCUMENT);
    if (bytes.isEmpty()) {
      return Optional.empty();
    }
    String[] lines = new String(bytes.get(), StandardCharsets.UTF_8).split("\n", 4);
    try {
      if (lines.length < 4) {
        throw new IllegalArgumentException("it has " + lines.length + " of 4 lines");
      }
      @Nullable Instant held = lines[2].equals(NOT_HELD) ? null : Instant.parse(lines[2]);
      return Optional.of(
          left(
              clock.instant(), UUID.fromString(lines[0]), Phase.valueOf(lines[1]), held, lines[3]));
    } catch (IllegalArgumentException | DateTimeParseException e) {
      throw new IOException("the goal of the earlier process cannot be read: " + e, e);
    }
  }

  /**
   * Reads who gave the earlier process its goal.
   *
   * @throws IOException if it cannot be read
   */
  void loadRequester() throws IOException {
    requester =
        state.read(REQUESTER).map(bytes -> new String(bytes, StandardCharsets.UTF_8)).orElse("");
  }

  /** Who gave the last goal; any thread may ask. */
  String requester() {
    return requester;
  }

  /**
   * Stores who gives a goal; by one thread at a time.
   *
   * @throws IOException if it cannot be written; this process knows it nevertheless
   */
  void storeRequester(String next) throws IOException {
    if (!next.equals(requester)) {
      requester = next;
      state.write(REQUESTER, next.getBytes(StandardCharsets.UTF_8));
    }
  }

  private static BehaviorStatus left(
      Instant now, UUID goal, Phase phase, @Nullable Instant held, String doing) {
    return switch (phase) {
      case RUNNING ->
          new BehaviorStatus(now, goal, Phase.IDLE, "its process ended before its goal", 0, 0);
      case PAUSED ->
          new BehaviorStatus(
              now,
              goal,
              Phase.CANCELLED,
              "its process ended while it paused: " + doing,
              0,
              0,
              held,
              0,
              0);
      case SUCCEEDED -> new BehaviorStatus(now, goal, phase, doing, 1, 0);
      default -> new BehaviorStatus(now, goal, phase, doing, 0, 0, held, 0, 0);
    };
  }
}
