package org.dfra.drivers.uav.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.MavCmd;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.dfra.drivers.fixture.StepTicker;
import org.dfra.drivers.uav.mavlink.MavlinkCommand.CommandLong;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.CommandAck;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class FlightCommandSequencerTest {

  private final CountDownLatch writing = new CountDownLatch(1);
  private final CountDownLatch release = new CountDownLatch(1);
  private final FlightCommandSequencer orders =
      new FlightCommandSequencer((order, step, result) -> {});
  private final CommandProtocol stuck =
      new CommandProtocol(new StepTicker(false), (command, times) -> write());

  private void write() {
    writing.countDown();
    try {
      release.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Test
  void callsOffTheOrderThatItHasLookedAtAndNoneAfterIt() {
    CommandProtocol protocol = new CommandProtocol(new StepTicker(false), (command, times) -> {});
    protocol.open();
    List<MavlinkCommand> arm = List.of(CommandLong.of(MavCmd.MAV_CMD_COMPONENT_ARM_DISARM, 1, 0));
    List<MavlinkCommand> mode = List.of(CommandLong.of(MavCmd.MAV_CMD_DO_SET_MODE, 1, 4));
    assertThat(orders.start("of the first", arm, protocol)).isTrue();
    boolean isDue =
        orders.tryCancelWithoutLock(() -> orders.start("of the second, just now", mode, protocol));
    assertThat(isDue).isTrue();
    protocol.acknowledge(new CommandAck(MavlinkEncoder.number(mode.get(0).id()), 0, 0, 0));
    assertThat(orders.status()).isEqualTo("of the second, just now: DO_SET_MODE is accepted");
    assertThat(orders.start("of the third", arm, protocol)).isTrue();
    assertThat(orders.tryCancelWithoutLock(() -> false)).as("it commands by now").isFalse();
    protocol.acknowledge(new CommandAck(MavlinkEncoder.number(arm.get(0).id()), 0, 0, 0));
    protocol.acknowledge(new CommandAck(MavlinkEncoder.number(arm.get(0).id()), 0, 0, 0));
    assertThat(orders.status()).isEqualTo("of the third: COMPONENT_ARM_DISARM is accepted");
  }

  @Test
  void readingTheLastOrderDoesNotWaitForItsWrite() throws Exception {
    stuck.open();
    List<MavlinkCommand> steps = List.of(CommandLong.of(MavCmd.MAV_CMD_COMPONENT_ARM_DISARM, 1, 0));
    CompletableFuture<Boolean> begun =
        CompletableFuture.supplyAsync(() -> orders.start("Arm", steps, stuck));
    assertThat(writing.await(20, TimeUnit.SECONDS)).isTrue();
    CompletableFuture<String> reported =
        CompletableFuture.supplyAsync(orders::status, task -> new Thread(task).start());
    try {
      assertThat(reported.get(10, TimeUnit.SECONDS)).isEqualTo("Arm awaits its answer");
      assertThat(begun).isNotDone();
    } finally {
      release.countDown();
    }
    assertThat(begun.get(20, TimeUnit.SECONDS)).isTrue();
  }
}
