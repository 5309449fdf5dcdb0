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
    PendingRelease farewell = state.farewell();
    if (farewell == null || now.isBefore(farewell.again())) {
      return TransitionResult.none(state);
    }
    return now.isBefore(farewell.until())
        ? release(state, farewell, "no longer needed", now)
        : TransitionResult.none(state.withPendingRelease(null)); // its commitment has expired
  }

  private TransitionResult<RequesterState, RequesterAction> release(
      RequesterState state, PendingRelease farewell, String why, Instant now) {
    return new TransitionResult<>(
        state.withPendingRelease(farewell.repeatedAt(now.plus(every))),
        List.of(
            new SendToRobot(farewell.robot(), new Release(farewell.conversation(), why, true))));
  }

  /** Handles a message, which may be the acknowledgement of the released helper. */
  static RequesterState receive(RequesterState state, String from, RecruitmentMessage message) {
    PendingRelease farewell = state.farewell();
    return farewell != null && farewell.isAcknowledgedBy(from, message)
        ? state.withPendingRelease(null)
        : state;
  }
}
