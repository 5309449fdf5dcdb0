package org.dfra.recruit.responder;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import org.dfra.agent.HelpCall;
import org.dfra.agent.ResponderPhase;
import org.dfra.geometry.GeoPosition;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.TransitionResult;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.RecruitmentMessage.Help;
import org.dfra.recruit.message.RecruitmentMessage.ResponderId;
import org.dfra.recruit.responder.ResponderAction.ExtendLease;
import org.dfra.recruit.responder.ResponderMachine.ResponderPolicy;
import org.junit.jupiter.api.Test;

/** A helper that offers again, and is chosen for its later offer while it is on its way. */
class ProlongedLeaseTest {

  private static final Duration ETA = Duration.ofSeconds(15);

  private final ResponderMachine machine =
      new ResponderMachine(
          "me",
          RecruitmentSettings.DEFAULT,
          new ResponderPolicy() {
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
          });

  @Test
  void itsRobotLearnsThatItHasLonger() {
    Conversation in = new Conversation("uav", 1);
    HelpCall call =
        new HelpCall(
            "mine", new GeoPosition(28, -82, 0), Duration.ofSeconds(10), Duration.ofSeconds(100));
    Instant now = Instant.EPOCH;
    ResponderState state = machine.receive(ResponderState.FREE, new Help(in, call, 1), now).state();
    now = now.plusSeconds(5);
    state = machine.receive(state, new Help(in, call, 2), now).state(); // its offer was lost
    state = machine.receive(state, new ResponderId(in, "me", 0), now).state();
    assertThat(state.phase()).isEqualTo(ResponderPhase.TRAVELLING);
    Instant first = state.until();

    TransitionResult<ResponderState, ResponderAction> longer =
        machine.receive(state, new ResponderId(in, "me", 1), now);
    assertThat(longer.state().until()).isEqualTo(first.plusSeconds(5));
    assertThat(longer.actions()).containsExactly(new ExtendLease(first.plusSeconds(5)));

    assertThat(machine.receive(longer.state(), new ResponderId(in, "me", 0), now).actions())
        .as("the shorter one changes nothing")
        .isEmpty();
  }
}
