package org.dfra.recruit.requester;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Set;
import java.util.UUID;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RequesterPhase;
import org.dfra.geometry.GeoPosition;
import org.dfra.recruit.Explorer;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.message.RecruitmentMessage.Accept;
import org.dfra.recruit.message.RecruitmentMessage.AckAck;
import org.dfra.recruit.message.RecruitmentMessage.Arrival;
import org.dfra.recruit.message.RecruitmentMessage.Refuse;
import org.dfra.recruit.strategy.Greedy;
import org.junit.jupiter.api.Test;

/**
 * Every state that a requester can come to, whatever two robots send it, ends by itself: if no
 * message is received any more, the call has ended within its patience and the promised times.
 */
class EveryCallEndsTest {

  private static final Duration PATIENCE = Duration.ofSeconds(40);
  private static final HelpCall CALL =
      new HelpCall("mine", new GeoPosition(28, -82, 0), Duration.ofSeconds(10), PATIENCE);

  private final RequesterMachine machine =
      new RequesterMachine(RecruitmentSettings.DEFAULT, new Greedy());

  private Explorer<RequesterState> explorer() {
    Explorer<RequesterState> all =
        new Explorer<RequesterState>(
                RequesterState::nextWake,
                (state, now) -> machine.tick(state, now).state(),
                state -> state.phase() == RequesterPhase.IDLE)
            .event((state, now) -> machine.release(state, now).state())
            .event(this::call);
    for (String robot : List.of("x", "y")) {
      for (long number : new long[] {1, 2}) {
        Conversation in = new Conversation("me", number);
        List<RecruitmentMessage> messages =
            List.of(
                new Accept(in, 0, Duration.ofSeconds(15), 1),
                new Accept(in, 1, Duration.ofSeconds(14), 1),
                new Refuse(in, "no", true),
                new Refuse(in, "not now", false),
                new Arrival(in, new UUID(1, 2), Duration.ofSeconds(10)),
                new AckAck(in));
        for (RecruitmentMessage message : messages) {
          all.event((state, now) -> machine.receive(state, robot, message, now).state());
        }
      }
    }
    return all;
  }

  private RequesterState call(RequesterState state, Instant now) {
    return state.phase().isUnderWay() ? state : machine.call(state, CALL, now).state();
  }

  @Test
  void everyReachableStateIsIdleInTheEnd() {
    RequesterState first = call(RequesterState.idle(new Conversation("me", 0)), Explorer.BEGIN);
    Set<RequesterState> seen = explorer().explore(first, PATIENCE.plus(Duration.ofSeconds(60)));
    assertThat(seen.stream().map(RequesterState::phase).distinct())
        .as("phases reached, by %d states", seen.size())
        .containsExactlyInAnyOrder(RequesterPhase.values());
  }
}
