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
 * Lets a helper go that has promised time: tells it so, and again until it says that it knows, or
 * is free by itself. What else the requester does goes on meanwhile.
 */
final class ReleaseRepeater {

  private final Duration every;

  /**
   * @param every it is told again after this
   */
  ReleaseRepeater(Duration every) {
    this.every = every;
  }

  /** Tells the helper of that state. */
  TransitionResult<RequesterState, RequesterAction> release(
      RequesterState state, String why, Instant now) {
    String robot = state.requireWinner().robot();
    Conversation in = state.conversation();
    return told(state, new Farewell(in, robot, now, state.until()), why, now);
  }

  /** Time has passed. */
  TransitionResult<RequesterState, RequesterAction> tick(RequesterState state, Instant now) {
    Farewell farewell = state.farewell();
    if (farewell == null || now.isBefore(farewell.again())) {
      return TransitionResult.none(state);
    }
    return now.isBefore(farewell.until())
        ? told(state, farewell, "not wanted any more", now)
        : TransitionResult.none(state.withPendingRelease(null)); // it is free by itself
  }

  private TransitionResult<RequesterState, RequesterAction> told(
      RequesterState state, Farewell farewell, String why, Instant now) {
    return new TransitionResult<>(
        state.withPendingRelease(farewell.repeatedAt(now.plus(every))),
        List.of(
            new SendToRobot(farewell.robot(), new Release(farewell.conversation(), why, true))));
  }

  /** Somebody has sent a message: perhaps whoever was let go, and knows it. */
  static RequesterState receive(RequesterState state, String from, RecruitmentMessage message) {
    Farewell farewell = state.farewell();
    return farewell != null && farewell.isAcknowledgedBy(from, message)
        ? state.withPendingRelease(null)
        : state;
  }
}
