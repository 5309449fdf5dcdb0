package org.dfra.examples.recruit;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import org.dfra.agent.HelpCall;
import org.dfra.geometry.GeoPosition;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.MessageEnvelope;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.message.RecruitmentMessage.Accept;
import org.dfra.recruit.message.RecruitmentMessage.Agree;
import org.dfra.recruit.message.RecruitmentMessage.Arrival;
import org.dfra.recruit.message.RecruitmentMessage.Help;
import org.dfra.recruit.message.RecruitmentMessage.ResponderId;
import org.dfra.recruit.message.SentMessage;
import org.junit.jupiter.api.Test;

/** The state of a call is derived from its messages, over all attempts. */
class CallStateTest {

  private static final Instant BEGIN = Instant.parse("2026-11-22T00:00:00Z");
  private static final GeoPosition PLACE = new GeoPosition(48.1, 11, 0);
  private static final Conversation FIRST = new Conversation("uav", 1);
  private static final Conversation SECOND = FIRST.next();

  private final List<SentMessage> envelopes = new ArrayList<>();

  private void sent(int second, String sender, RecruitmentMessage message) {
    Instant time = BEGIN.plusSeconds(second);
    envelopes.add(new SentMessage(time, "", new MessageEnvelope(sender, second, time, message)));
  }

  private static Help help(Conversation in, GeoPosition place, int round) {
    return new Help(
        in, new HelpCall("mine", place, Duration.ofSeconds(60), Duration.ofSeconds(99)), round);
  }

  private CallState state() {
    return CallState.last(Conversations.of(envelopes), "uav").orElseThrow();
  }

  @Test
  void aRobotThatHasNotCalledHasNoCall() {
    sent(0, "ugv4", help(new Conversation("ugv4", 1), PLACE, 1));
    assertThat(CallState.last(Conversations.of(envelopes), "uav")).isEmpty();
    assertThat(CallState.last(List.of(), "uav")).isEmpty();
  }

  @Test
  void callsUntilSomebodyIsChosen() {
    sent(0, "uav", help(FIRST, PLACE, 1));
    sent(5, "uav", help(FIRST, PLACE, 2));
    assertThat(state())
        .isEqualTo(new CallState("uav", 1, PLACE, BEGIN, null, List.of(), 2, 2, null));
    assertThat(state().seconds(BEGIN.plusMillis(7500))).isEqualTo(7.5);
    sent(6, "ugv1", new Accept(FIRST, 0, Duration.ofSeconds(20), 1));
    assertThat(state().chosen()).as("it has only offered").isNull();
    sent(7, "uav", new ResponderId(FIRST, "ugv1", 0));
    assertThat(state().chosen()).isEqualTo("ugv1");
    assertThat(state().leaseEnd()).as("it is on its way").isNull();
  }

  @Test
  void theLeaseCountsFromTheLastArrival() {
    sent(0, "uav", help(FIRST, PLACE, 1));
    sent(7, "uav", new ResponderId(FIRST, "ugv1", 0));
    sent(30, "ugv1", new Arrival(FIRST, new UUID(0, 1), Duration.ofSeconds(60)));
    assertThat(state().leaseEnd()).isEqualTo(BEGIN.plusSeconds(90));
    sent(36, "ugv1", new Arrival(FIRST, new UUID(0, 1), Duration.ofSeconds(53)));
    sent(37, "uav", new Agree(FIRST));
    assertThat(state().leaseEnd()).isEqualTo(BEGIN.plusSeconds(89));
    assertThat(state().messages()).isEqualTo(5);
  }

  @Test
  void aReplacedHelperIsLost() {
    sent(0, "uav", help(FIRST, PLACE, 1));
    sent(7, "uav", new ResponderId(FIRST, "ugv2", 0));
    sent(30, "ugv2", new Arrival(FIRST, new UUID(0, 1), Duration.ofSeconds(60)));
    sent(60, "uav", help(SECOND, PLACE, 1));
    assertThat(state().chosen()).as("of the first attempt").isNull();
    assertThat(state().leaseEnd()).as("of the first attempt").isNull();
    assertThat(state().lost()).containsExactly("ugv2");
    sent(66, "uav", new ResponderId(SECOND, "ugv4", 0));
    assertThat(state())
        .isEqualTo(new CallState("uav", 1, PLACE, BEGIN, "ugv4", List.of("ugv2"), 2, 5, null));
    sent(67, "uav", new ResponderId(SECOND, "ugv2", 0));
    assertThat(state().lost()).as("it is back, and the other is not").containsExactly("ugv4");
  }

  @Test
  void theNextCallResetsTheState() {
    sent(0, "uav", help(FIRST, PLACE, 1));
    sent(7, "uav", new ResponderId(FIRST, "ugv2", 0));
    GeoPosition elsewhere = new GeoPosition(48.2, 11, 0);
    sent(60, "uav", help(SECOND, elsewhere, 1));
    assertThat(state())
        .isEqualTo(
            new CallState("uav", 2, elsewhere, BEGIN.plusSeconds(60), null, List.of(), 1, 1, null));
  }
}
