package org.dfra.recruit.requester;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dfra.recruit.TransitionResult;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.message.RecruitmentMessage.Release;
import org.dfra.recruit.requester.RequesterAction.SendToRobot;

/**
 * Releases a committed helper: sends a RELEASE, and repeats it until the helper acknowledges it or
 * its commitment expires. The requester's other work continues meanwhile.
 */
final class ReleaseRepeater {

  private final Duration every;

  /**
   * @param every period of repetition
   */
  ReleaseRepeater(Duration every) {
    this.every = every;
  }

  /** Releases the helper of a state. */
  TransitionResult<RequesterState, RequesterAction> release(
      RequesterState state, String why, Instant now) {
    String robot = state.requireWinner().robot();
    Conversation in = state.conversation();
    return release(state, new PendingRelease(in, robot, now, state.until()), why, now);
  }

  /** Advances the time. */
  TransitionResult<RequesterState, RequesterAction> tick(RequesterState state, Instant now) {
    PendingRelease pendingRelease = state.farewell();
    if (pendingRelease == null || now.isBefore(pendingRelease.again())) {
      return TransitionResult.none(state);
    }
    return now.isBefore(pendingRelease.until())
        ? release(state, pendingRelease, "no longer needed", now)
        : TransitionResult.none(state.withPendingRelease(null)); // its commitment has expired
  }

  private TransitionResult<RequesterState, RequesterAction> release(
      RequesterState state, PendingRelease pendingRelease, String why, Instant now) {
    return new TransitionResult<>(
        state.withPendingRelease(pendingRelease.repeatedAt(now.plus(every))),
        List.of(
            new SendToRobot(
                pendingRelease.robot(), new Release(pendingRelease.conversation(), why, true))));
  }

  /** Handles a message, which may be the acknowledgement of the released helper. */
  static RequesterState receive(RequesterState state, String from, RecruitmentMessage message) {
    PendingRelease pendingRelease = state.farewell();
    return pendingRelease != null && pendingRelease.isAcknowledgedBy(from, message)
        ? state.withPendingRelease(null)
        : state;
  }
}
