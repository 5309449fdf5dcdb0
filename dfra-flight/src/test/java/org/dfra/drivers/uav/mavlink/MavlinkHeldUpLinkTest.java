package org.dfra.drivers.uav.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.drivers.fixture.Modules.await;
import static org.dfra.drivers.fixture.Modules.awaitReadiness;
import static org.dfra.drivers.fixture.Modules.beside;
import static org.dfra.drivers.fixture.Modules.parameter;

import io.dronefleet.mavlink.common.MavCmd;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.dfra.drivers.fixture.ScriptedLink;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.FlightCommand.GoTo;
import org.dfra.lifecycle.Readiness;
import org.junit.jupiter.api.Test;

/** A flight controller on a link that holds up what is written to it. */
class MavlinkHeldUpLinkTest extends MavlinkFixture {

  /** Starts it, has it fly, and takes the command. */
  private CommandLease commandInTheAir(MavlinkFlightImpl flight) throws Exception {
    flight.start();
    say(HEARTBEAT, RECEIVER, FLIES, POSITION);
    awaitReadiness(flight, Readiness.READY);
    return flight.acquireCommandLease(Duration.ofSeconds(10));
  }

  /** Has it fly, and commands it to fly elsewhere, which hangs in the link until the release. */
  private CompletableFuture<Void> holdUpACommand(MavlinkFlightImpl flight, CountDownLatch release)
      throws Exception {
    CommandLease lease = commandInTheAir(flight);
    links.get(0).holdUpAWrite(release);
    GoTo away = new GoTo(flight.flightState().position(), 3);
    return beside(() -> flight.execute(lease.key(), away));
  }

  @Test
  void holdsItsPlacePastACommandThatHangsInTheLink() throws Exception {
    try (MavlinkFlightImpl flight = new MavlinkFlightImpl(context("flight"), ticker, source)) {
      CountDownLatch release = new CountDownLatch(1);
      CompletableFuture<Void> writing = holdUpACommand(flight, release);
      ScriptedLink link = links.get(0);
      try {
        await().until(() -> isSent(link, MavCmd.MAV_CMD_DO_REPOSITION));
        assertThat(isSent(link, MavCmd.MAV_CMD_DO_SET_MODE)).isFalse();
        assertThat(flight.emergencyStop("ops").latched()).isTrue();
        await().until(() -> isSent(link, MavCmd.MAV_CMD_DO_SET_MODE));
        assertThat(writing).isNotDone();
      } finally {
        release.countDown();
      }
      writing.get(60, TimeUnit.SECONDS);
      // 2; a third, which is harmless, where the reader held its lock for long on a busy computer
      await().until(() -> modesSet(link) >= 2);
      link.awaitLooked();
      say(MODE_ACCEPTED); // the first of them; the second was lost
      await().until(() -> parameter(flight, "last_command").endsWith("DO_SET_MODE is accepted"));
      long sent = modesSet(link);
      ticker.step(Duration.ofMillis(2100));
      await("the second is sent again").until(() -> modesSet(link) == sent + 1);
      say(HEARTBEAT, MODE_ACCEPTED);
      await().until(() -> link.isTaken());
      link.awaitLooked();
      ticker.step(Duration.ofMillis(2100));
      link.awaitLooked();
      assertThat(modesSet(link)).as("once the vehicle has accepted it").isEqualTo(sent + 1);
    }
  }

  @Test
  void holdsItsPlacePastAWriteOfTheReaderThatHangsAndOnceMoreAfterIt() throws Exception {
    try (MavlinkFlightImpl flight = new MavlinkFlightImpl(context("flight"), ticker, source)) {
      CommandLease lease = commandInTheAir(flight);
      ScriptedLink link = links.get(0);
      flight.execute(lease.key(), new GoTo(flight.flightState().position(), 3));
      link.awaitLooked();
      CountDownLatch release = new CountDownLatch(1);
      link.holdUpTheReader(release);
      long written = link.written().size();
      try {
        ticker.step(Duration.ofMillis(750)); // unanswered, so it is sent again
        await().until(() -> link.written().size() > written);
        assertThat(isSent(link, MavCmd.MAV_CMD_DO_SET_MODE)).isFalse();
        assertThat(flight.emergencyStop("ops").latched()).isTrue();
        await().until(() -> isSent(link, MavCmd.MAV_CMD_DO_SET_MODE));
        await().until(() -> flight.emergencyStopState().haltCommanded());
      } finally {
        release.countDown();
      }
      link.awaitLooked();
      ticker.step(Duration.ofMillis(2100));
      await("as what the vehicle did not accept").until(() -> modesSet(link) >= 2);
    }
  }

  private static long modesSet(ScriptedLink link) {
    return link.written().stream()
        .filter(each -> isCommand(each, MavCmd.MAV_CMD_DO_SET_MODE))
        .count();
  }

  @Test
  void aModuleEndsThoughItsCommandHangsInTheLink() throws Exception {
    MavlinkFlightImpl flight = new MavlinkFlightImpl(context("flight"), ticker, source);
    CountDownLatch release = new CountDownLatch(1);
    try {
      CompletableFuture<Void> writing = holdUpACommand(flight, release);
      ScriptedLink link = links.get(0);
      await().until(() -> isSent(link, MavCmd.MAV_CMD_DO_REPOSITION));
      link.awaitLooked(); // the reader goes on
      beside(flight::close).get(40, TimeUnit.SECONDS);
      assertThat(link.isOpen()).isFalse();
      assertThat(writing).isNotDone();
    } finally {
      release.countDown();
      flight.close();
    }
  }

  @Test
  void aVehicleThatFallsSilentWhileACommandHangsIsNoticed() throws Exception {
    CountDownLatch release = new CountDownLatch(1);
    try (MavlinkFlightImpl flight = new MavlinkFlightImpl(context("flight"), ticker, source)) {
      CompletableFuture<Void> writing = holdUpACommand(flight, release);
      ScriptedLink link = links.get(0);
      try {
        await().until(() -> isSent(link, MavCmd.MAV_CMD_DO_REPOSITION));
        ticker.step(Duration.ofMillis(3100));
        await("closing it may set the command free").until(() -> !link.isOpen());
        assertThat(writing).isNotDone();
      } finally {
        release.countDown();
      }
    }
  }

  /** By the number of the command, which stands behind 28 bytes of a {@code COMMAND_LONG}. */
  private static boolean isCommand(byte[] frame, MavCmd command) {
    return frame.length > 40
        && (frame[7] == 76 || frame[7] == 75)
        && ((frame[38] & 0xFF) | (frame[39] & 0xFF) << 8) == MavlinkEncoder.number(command);
  }

  private static boolean isSent(ScriptedLink link, MavCmd command) {
    return link.written().stream().anyMatch(each -> isCommand(each, command));
  }
}
