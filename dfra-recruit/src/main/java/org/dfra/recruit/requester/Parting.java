package org.dfra.recruit.requester;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dfra.recruit.Step;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.message.RecruitmentMessage.Release;
import org.dfra.recruit.requester.RequesterAction.ToOne;

/**
 * Lets a helper go that has promised time: tells it so, and again until it says that it knows, or
 * is free by itself. What else the requester does goes on meanwhile.
 */
final class Parting {

  private final Duration every;

  /**
   * @param every it is told again after this
   */
  Parting(Duration every) {
    this.every = every;
  }

  /** Tells the helper of that state. */
  Step<RequesterState, RequesterAction> letGo(RequesterState state, String why, Instant now) {
    String robot = state.chosen().robot();
    Conversation in = state.conversation();
    return told(state, new Farewell(in, robot, now, state.until()), why, now);
  }

  /** Time has passed. */
  Step<RequesterState, RequesterAction> tick(RequesterState state, Instant now) {
    Farewell farewell = state.farewell();
    if (farewell == null || now.isBefore(farewell.again())) {
      return Step.none(state);
    }
    return now.isBefore(farewell.until())
        ? told(state, farewell, "not wanted any more", now)
        : Step.none(state.parting(null)); // it is free by itself
  }

  private Step<RequesterState, RequesterAction> told(
      RequesterState state, Farewell farewell, String why, Instant now) {
    return new Step<>(
        state.parting(farewell.toldAgain(now.plus(every))),
        List.of(new ToOne(farewell.robot(), new Release(farewell.conversation(), why, true))));
  }

  /** Somebody has sent a message: perhaps whoever was let go, and knows it. */
  static RequesterState hear(RequesterState state, String from, RecruitmentMessage message) {
    Farewell farewell = state.farewell();
    return farewell != null && farewell.isHeardBy(from, message) ? state.parting(null) : state;
  }
}
