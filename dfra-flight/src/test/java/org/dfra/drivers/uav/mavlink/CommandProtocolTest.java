package org.dfra.drivers.uav.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.MavCmd;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dfra.drivers.fixture.StepTicker;
import org.dfra.drivers.uav.mavlink.MavlinkCommand.CommandLong;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.CommandAck;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class CommandProtocolTest {

  private static final int ARM = 400;
  private static final int INTERVAL = 511;
  private static final int ACCEPTED = 0;
  private static final int DENIED = 2;
  private static final int IN_PROGRESS = 5;

  private final StepTicker ticker = new StepTicker(false);
  private final List<String> sent = new ArrayList<>();
  private final List<String> ended = new ArrayList<>();
  private final CommandProtocol protocol =
      new CommandProtocol(
          ticker,
          (command, times) -> sent.add(command.name() + " " + parameter(command) + " #" + times));

  @BeforeEach
  void find() {
    protocol.open();
  }

  @Test
  void sendsAndReportsNothingWithoutAVehicle() {
    protocol.lost();
    assertThat(begin(arm(1))).isNull();
    assertThat(sent).isEmpty();
    protocol.open();
    protocol.resendDue();
    assertThat(sent).isEmpty();
  }

  @Test
  void endsWithTheAnswer() {
    begin(arm(1));
    answer(ARM, DENIED);
    assertThat(sent).containsExactly("COMPONENT_ARM_DISARM 1.0 #0");
    assertThat(ended).containsExactly("COMPONENT_ARM_DISARM 1.0 is denied");
    pass(10_000);
    assertThat(sent).hasSize(1);
  }

  @Test
  void sendsAgainFourTimesInAllAndGivesUp() {
    begin(arm(1));
    pass(600);
    assertThat(sent).hasSize(1);
    pass(100);
    assertThat(sent).hasSize(2).last().isEqualTo("COMPONENT_ARM_DISARM 1.0 #1");
    pass(700);
    pass(700);
    assertThat(sent).hasSize(4).last().isEqualTo("COMPONENT_ARM_DISARM 1.0 #3");
    assertThat(ended).isEmpty();
    pass(700);
    assertThat(sent).hasSize(4);
    assertThat(ended)
        .containsExactly("COMPONENT_ARM_DISARM 1.0 was sent 4 times and is not answered");
  }

  @Test
  void waitsForWhatIsInProgressAndDoesNotSendItAgain() {
    begin(arm(1));
    answer(ARM, IN_PROGRESS);
    pass(9000);
    assertThat(sent).hasSize(1);
    answer(ARM, ACCEPTED);
    assertThat(ended).containsExactly("COMPONENT_ARM_DISARM 1.0 is accepted");
  }

  @Test
  void givesUpWhatIsInProgressForTooLong() {
    begin(arm(1));
    answer(ARM, IN_PROGRESS);
    pass(10_000);
    assertThat(ended).hasSize(1).first().asString().endsWith("is not answered");
  }

  @Test
  void letsOneOfASortGoAtATimeSinceAnAnswerNamesTheSort() {
    begin(interval(24));
    begin(interval(33));
    begin(arm(1));
    assertThat(sent).containsExactly("SET_MESSAGE_INTERVAL 24.0 #0", "COMPONENT_ARM_DISARM 1.0 #0");
    answer(INTERVAL, DENIED);
    assertThat(ended).containsExactly("SET_MESSAGE_INTERVAL 24.0 is denied");
    assertThat(sent).last().isEqualTo("SET_MESSAGE_INTERVAL 33.0 #0");
    answer(INTERVAL, ACCEPTED);
    assertThat(ended).last().isEqualTo("SET_MESSAGE_INTERVAL 33.0 is accepted");
  }

  @Test
  void doesNotTakeASecondAnswerToTheLastForTheAnswerToTheNext() {
    begin(interval(24));
    pass(700); // sent again, though the first had arrived
    begin(interval(33));
    answer(INTERVAL, ACCEPTED);
    assertThat(ended).containsExactly("SET_MESSAGE_INTERVAL 24.0 is accepted");
    answer(INTERVAL, ACCEPTED); // to the repetition
    assertThat(ended).hasSize(1);
    answer(INTERVAL, DENIED);
    assertThat(ended).last().isEqualTo("SET_MESSAGE_INTERVAL 33.0 is denied");
  }

  @Test
  void doesNotTakeTheAnswerToWhatWasCalledOffForTheAnswerToTheNext() {
    CommandProtocol.Exchange first = begin(arm(1));
    protocol.cancel(first);
    begin(arm(0));
    assertThat(sent).last().isEqualTo("COMPONENT_ARM_DISARM 0.0 #0");
    answer(ARM, ACCEPTED);
    assertThat(ended).isEmpty();
    answer(ARM, DENIED);
    assertThat(ended).containsExactly("COMPONENT_ARM_DISARM 0.0 is denied");
  }

  @Test
  void sendsOnceMoreWhenAStrayAnswerWasLostItself() {
    CommandProtocol.Exchange first = begin(arm(1));
    protocol.cancel(first);
    begin(arm(0));
    answer(ARM, ACCEPTED); // meant for the second: the first never arrived
    pass(700);
    assertThat(sent).last().isEqualTo("COMPONENT_ARM_DISARM 0.0 #1");
    answer(ARM, ACCEPTED);
    assertThat(ended).containsExactly("COMPONENT_ARM_DISARM 0.0 is accepted");
  }

  @Test
  void neverSendsAgainWhatWasCalledOff() {
    CommandProtocol.Exchange exchange = begin(arm(1));
    protocol.cancel(exchange);
    pass(10_000);
    assertThat(sent).hasSize(1);
    assertThat(ended).isEmpty();
  }

  @Test
  void reportsWhatWasUnderWayWhenTheLinkWasLost() {
    begin(arm(1));
    begin(interval(24));
    begin(interval(33));
    protocol.lost();
    assertThat(ended)
        .hasSize(3)
        .allMatch(end -> end.endsWith("the link was lost before an answer came"));
    protocol.open();
    pass(10_000);
    assertThat(sent).hasSize(2);
  }

  @Test
  void passesOverAnswersToNothing() {
    answer(ARM, ACCEPTED);
    answer(65_535, ACCEPTED);
    assertThat(ended).isEmpty();
  }

  private CommandProtocol.Exchange begin(MavlinkCommand command) {
    return protocol.submit(
        command, result -> ended.add(command.name() + " " + parameter(command) + " " + result));
  }

  private void answer(int command, int result) {
    protocol.acknowledge(new CommandAck(command, result, 0, 0));
  }

  private void pass(int millis) {
    ticker.step(Duration.ofMillis(millis));
    protocol.resendDue();
  }

  private static double parameter(MavlinkCommand command) {
    return ((CommandLong) command).p1();
  }

  private static MavlinkCommand arm(int wanted) {
    return CommandLong.of(MavCmd.MAV_CMD_COMPONENT_ARM_DISARM, wanted, 0);
  }

  private static MavlinkCommand interval(int message) {
    return CommandLong.of(MavCmd.MAV_CMD_SET_MESSAGE_INTERVAL, message, 200_000);
  }
}
