package org.dfra.recruit.responder;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import org.dfra.agent.HelpCall;
import org.dfra.agent.ResponderPhase;
import org.dfra.geometry.GeoPosition;
import org.dfra.recruit.Explorer;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.message.RecruitmentMessage.Agree;
import org.dfra.recruit.message.RecruitmentMessage.Help;
import org.dfra.recruit.message.RecruitmentMessage.Release;
import org.dfra.recruit.message.RecruitmentMessage.ResponderId;
import org.dfra.recruit.responder.ResponderMachine.ResponderPolicy;
import org.junit.jupiter.api.Test;

/**
 * Every state that a responder can come to, whatever two requesters send it, in any order and at
 * any time, ends by itself: if no message is received any more and its robot never arrives, it is
 * free within a bound.
 */
class EveryStateEndsTest {

  private static final UUID LEASE = new UUID(1, 2);
  private static final Duration STAY = Duration.ofSeconds(10);
  private static final Duration ETA = Duration.ofSeconds(15);
  private static final HelpCall CALL =
      new HelpCall("mine", new GeoPosition(28, -82, 0), STAY, Duration.ofSeconds(100));

  private static final class Willing implements ResponderPolicy {
    @Override
    public Optional<Offer> offer(HelpCall call) {
      return Optional.of(new Offer(ETA, 1));
    }

    @Override
    public boolean shouldOffer(Help help, Offer offer) {
      return true;
    }

    @Override
    public boolean sendsRefusal() {
      return false;
    }
  }

  private final ResponderMachine machine =
      new ResponderMachine("me", RecruitmentSettings.DEFAULT, new Willing());

  private Explorer<ResponderState> explorer() {
    Explorer<ResponderState> all =
        new Explorer<ResponderState>(
                ResponderState::nextWake,
                (state, now) -> machine.tick(state, now).state(),
                state -> state.phase() == ResponderPhase.FREE)
            .event((state, now) -> machine.arrived(state, LEASE, STAY, now).state())
            .event((state, now) -> machine.abort(state, "it is stuck").state())
            .event((state, now) -> machine.leaseEnded(state, LEASE, now).state())
            .late(Duration.ofSeconds(7)); // its timer was late
    for (Conversation in :
        List.of(new Conversation("a", 1), new Conversation("a", 2), new Conversation("b", 1))) {
      List<RecruitmentMessage> messages =
          List.of(
              new Help(in, CALL, 1),
              new Help(in, CALL, 2),
              new ResponderId(in, "me", 0),
              new ResponderId(in, "me", 1),
              new ResponderId(in, "other", 0),
              new Agree(in),
              new Release(in, "enough", false),
              new Release(in, "enough", true));
      for (RecruitmentMessage message : messages) {
        all.event((state, now) -> machine.receive(state, message, now).state());
      }
    }
    return all;
  }

  @Test
  void everyReachableStateIsFreeInTheEnd() {
    Set<ResponderState> seen =
        explorer().explore(ResponderState.FREE, ETA.plus(Duration.ofSeconds(60)));
    assertThat(seen.stream().map(ResponderState::phase).distinct())
        .as("phases reached, by %d states", seen.size())
        .containsExactlyInAnyOrder(ResponderPhase.values());
  }
}
