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
 * What a behaviour says of itself: one status, which follows the arrows of {@link Phase}. Several
 * threads move it: the one that takes turns, and those that pause, resume and cancel. Whoever comes
 * second finds that the arrow he wanted does not begin where the status is now, and changes
 * nothing.
 *
 * <p>Those who listen are told under this object's lock, in the order of what happened; they must
 * not wait.
 */
final class BehaviorStatusTracker {

  private static final double NOTABLE = 0.005; // share of the goal that is worth an event

  /**
   * How far a goal is.
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

    /** The same, but not less of the goal than {@code before}. */
    Completion notBelow(double before) {
      return new Completion(Math.max(before, completion), skippedParts, completedParts, totalParts);
    }
  }

  private final InstantSource clock;
  private final Consumer<BehaviorStatus> listener;
  private final BiConsumer<Phase, BehaviorStatus> onPhase;
  private volatile BehaviorStatus status; // written under this object's lock

  /**
   * @param listener is told each status that is news
   * @param onPhase is told, before that, the phase that was left and the status with the new one
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

  /** What an earlier process has left; nobody is told. */
  synchronized void restore(BehaviorStatus left) {
    status = left;
  }

  /** There is a new goal, whatever was before. One that begins with a pause waits for a person. */
  synchronized void begin(UUID goal, Phase phase, String doing, Completion extent) {
    publish(goal, phase, doing, extent, phase == Phase.PAUSED ? held() : null);
  }

  /**
   * The same goal, in another phase.
   *
   * @param isHeld whether it does not go on from there without a person; one that is given up by a
   *     program stays held where it was
   * @return false where it is in none of the phases {@code from}: nothing is changed
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

  /** How far it is now; nothing where somebody has stopped it meanwhile. */
  void updateProgress(String doing, Completion extent) {
    end(Phase.RUNNING, doing, extent);
  }

  /**
   * It runs no more, for this reason; nothing where somebody has stopped it meanwhile. What pauses
   * or cancels a goal from within is an emergency stop, a brake, or somebody who stopped a part of
   * it: it is held.
   */
  synchronized void end(Phase phase, String why, Completion extent) {
    if (status.phase() == Phase.RUNNING) {
      boolean isHeld = phase == Phase.PAUSED || phase == Phase.CANCELLED;
      publish(status.goal(), phase, why, extent, isHeld ? held() : null);
    }
  }

  /** As exact as the persona tells it, so that both name the same stop. */
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
