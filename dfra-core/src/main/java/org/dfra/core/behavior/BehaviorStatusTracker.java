package org.dfra.core.behavior;

import java.time.Instant;
import java.time.InstantSource;
import java.time.temporal.ChronoUnit;
import java.util.Objects;
import java.util.Set;
import java.util.UUID;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.jspecify.annotations.Nullable;

/**
 * The status of a behaviour, which follows the transitions of {@link Phase}. Several threads change
 * it: the control loop's, and those of callers that pause, resume and cancel. If two conflict, the
 * second finds that its transition does not start at the current phase, and changes nothing.
 *
 * <p>Listeners are notified under this object's lock, in order; they must not block.
 */
final class BehaviorStatusTracker {

  private static final double NOTABLE = 0.005; // progress of the goal that triggers an event

  /**
   * The progress of a goal.
   *
   * @see BehaviorStatus
   */
  record Completion(double completion, int skippedParts, int completedParts, int totalParts) {

    static final Completion NONE = new Completion(0, 0, 0, 0);

    static Completion of(BehaviorStatus status) {
      return new Completion(
          status.completion(), status.skippedParts(), status.completedParts(), status.totalParts());
    }

    static Completion of(GoalProgress progress) {
      return new Completion(
          progress.completion(),
          progress.skippedParts(),
          progress.completedParts(),
          progress.totalParts());
    }

    /** A copy whose completion is not below that of {@code before}. */
    Completion notBelow(double before) {
      return new Completion(Math.max(before, completion), skippedParts, completedParts, totalParts);
    }
  }

  private final InstantSource clock;
  private final Consumer<BehaviorStatus> listener;
  private final BiConsumer<Phase, BehaviorStatus> onPhase;
  private volatile BehaviorStatus status; // written under this object's lock

  /**
   * @param listener receives each new status
   * @param onPhase receives, before that, the previous phase and the new status
   */
  BehaviorStatusTracker(
      InstantSource clock,
      Consumer<BehaviorStatus> listener,
      BiConsumer<Phase, BehaviorStatus> onPhase) {
    this.clock = clock;
    this.listener = listener;
    this.onPhase = onPhase;
    this.status = new BehaviorStatus(clock.instant(), null, Phase.IDLE, "it has no goal yet", 0, 0);
  }

  BehaviorStatus status() {
    return status;
  }

  Phase phase() {
    return status.phase();
  }

  /** Restores the status of an earlier process, without notification. */
  synchronized void restore(BehaviorStatus left) {
    status = left;
  }

  /** Starts a new goal from any phase. One that starts paused waits for an operator. */
  synchronized void begin(UUID goal, Phase phase, String doing, Completion extent) {
    publish(goal, phase, doing, extent, phase == Phase.PAUSED ? held() : null);
  }

  /**
   * Moves the same goal to another phase.
   *
   * @param isHeld whether only an operator can continue it from there; a held goal that a program
   *     cancels stays held
   * @return false if it is in none of the phases {@code from}: nothing is changed
   */
  synchronized boolean transition(Set<Phase> from, Phase to, String doing, boolean isHeld) {
    BehaviorStatus last = status;
    if (!from.contains(last.phase())) {
      return false;
    }
    @Nullable Instant earlier = to == Phase.CANCELLED ? last.heldSince() : null;
    @Nullable Instant held = isHeld ? held() : earlier;
    publish(last.goal(), to, doing, Completion.of(last), held);
    return true;
  }

  /** Updates the progress; no effect if the goal was stopped meanwhile. */
  void updateProgress(String doing, Completion extent) {
    end(Phase.RUNNING, doing, extent);
  }

  /**
   * Ends or pauses the running goal for this reason; no effect if it was stopped meanwhile. A step
   * pauses or cancels its goal because of an emergency stop, a brake, or an operator that stopped a
   * part of it: the goal is then held.
   */
  synchronized void end(Phase phase, String why, Completion extent) {
    if (status.phase() == Phase.RUNNING) {
      boolean isHeld = phase == Phase.PAUSED || phase == Phase.CANCELLED;
      publish(status.goal(), phase, why, extent, isHeld ? held() : null);
    }
  }

  /** With the persona's resolution, so that both name the same stop. */
  private Instant held() {
    return clock.instant().truncatedTo(ChronoUnit.MILLIS);
  }

  private void publish(
      @Nullable UUID goal,
      Phase phase,
      String doing,
      Completion extent,
      @Nullable Instant heldSince) {
    BehaviorStatus last = status;
    boolean same =
        Objects.equals(goal, last.goal())
            && phase == last.phase()
            && doing.equals(last.activity())
            && Objects.equals(heldSince, last.heldSince())
            && extent.equals(
                new Completion(
                    extent.completion(),
                    last.skippedParts(),
                    last.completedParts(),
                    last.totalParts()));
    if (same && extent.completion() - last.completion() < NOTABLE) {
      return;
    }
    BehaviorStatus fresh =
        new BehaviorStatus(
            clock.instant(),
            goal,
            phase,
            doing,
            extent.completion(),
            extent.skippedParts(),
            heldSince,
            extent.completedParts(),
            extent.totalParts());
    status = fresh;
    if (phase != last.phase()) {
      onPhase.accept(last.phase(), fresh);
    }
    listener.accept(fresh);
  }
}
