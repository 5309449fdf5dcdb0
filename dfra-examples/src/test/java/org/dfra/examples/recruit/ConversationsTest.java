package org.dfra.examples.recruit;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dfra.agent.HelpCall;
import org.dfra.examples.recruit.Conversations.Attempt;
import org.dfra.geometry.GeoPosition;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.MessageEnvelope;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.message.RecruitmentMessage.Agree;
import org.dfra.recruit.message.RecruitmentMessage.Help;
import org.dfra.recruit.message.SentMessage;
import org.junit.jupiter.api.Test;

/** Calls and attempts are numbered for people, whatever the agents number them. */
class ConversationsTest {

  private static final Instant BEGIN = Instant.parse("2026-11-21T00:00:00Z");

  private static HelpCall call(double latitude) {
    return new HelpCall(
        "mine", new GeoPosition(latitude, 11, 0), Duration.ofSeconds(9), Duration.ofSeconds(99));
  }

  private static SentMessage sent(int second, RecruitmentMessage message) {
    Instant time = BEGIN.plusSeconds(second);
    String sender = message.conversation().requester();
    return new SentMessage(time, "", new MessageEnvelope(sender, second, time, message));
  }

  @Test
  void aCallWhoseHelperIsReplacedHasASecondAttempt() {
    Conversation first = new Conversation("uav", 1_795_316_123_366L);
    Conversation again = first.next();
    Conversation other = again.next();
    List<Attempt> all =
        Conversations.of(
            List.of(
                sent(60, new Help(other, call(48.2), 1)),
                sent(0, new Help(first, call(48.1), 1)),
                sent(5, new Help(first, call(48.1), 2)),
                sent(40, new Help(again, call(48.1), 1)),
                sent(50, new Agree(again))));
    assertThat(all)
        .extracting(Attempt::file)
        .containsExactly("call-1-attempt-1", "call-1-attempt-2", "call-2-attempt-1");
    assertThat(all.get(1).begun()).isEqualTo(BEGIN.plusSeconds(40));
    assertThat(all.get(1).messages()).hasSize(2);
  }

  @Test
  void twoThatCallAtOnceHaveCallsOfTheirOwn() {
    Conversation uav = new Conversation("uav", 7);
    Conversation ugv = new Conversation("ugv", 7);
    List<Attempt> all =
        Conversations.of(
            List.of(
                sent(0, new Help(uav, call(48.1), 1)),
                sent(1, new Help(ugv, call(48.1), 1)),
                sent(9, new Help(uav.next(), call(48.1), 1))));
    assertThat(all)
        .extracting(Attempt::file)
        .containsExactly("call-1-attempt-1", "call-2-attempt-1", "call-1-attempt-2");
  }

  @Test
  void aConversationOfWhichNoCallWasReceivedIsLeftOut() {
    assertThat(Conversations.of(List.of(sent(0, new Agree(new Conversation("uav", 1)))))).isEmpty();
  }
}
