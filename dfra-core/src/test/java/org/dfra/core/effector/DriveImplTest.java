package org.dfra.core.effector;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.Map;
import java.util.UUID;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.lease.SteppedScheduler;
import org.dfra.flow.effector.BrakeEngagedException;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.DriveCommand.Brake;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lifecycle.Incident;
import org.dfra.module.NotReadyException;
import org.dfra.persona.DriveAttributes;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DriveImplTest {

  private static final Duration LEASE = Duration.ofSeconds(30);
  private static final Velocity AHEAD = new Velocity(0.5, 0);

  private final SteppedScheduler time = new SteppedScheduler();
  private final ScriptedWheels wheels = started(Map.of());

  private ScriptedWheels started(Map<String, String> parameters) {
    ScriptedWheels made = new ScriptedWheels(time, parameters);
    made.start();
    return made;
  }

  @AfterEach
  void close() {
    wheels.close();
  }

  private CommandKey key() throws LeaseRefusedException {
    return wheels.acquireCommandLease(LEASE).key();
  }

  @Test
  void haltsExactlyWhenTheSilenceIsTooLong() throws Exception {
    wheels.execute(key(), AHEAD);
    time.step(Duration.ofMillis(300).minusNanos(1));
    assertThat(wheels.commands).containsExactly("turn 0.5 0.0");
    time.step(Duration.ofNanos(1));
    assertThat(wheels.commands).containsExactly("turn 0.5 0.0", "halt");
    assertThat(wheels.driveState().velocity()).isEqualTo(Velocity.ZERO);
    assertThat(wheels.driveState().commandTimeouts()).isEqualTo(1);
    time.step(Duration.ofSeconds(10));
    assertThat(wheels.commands).as("said once").hasSize(2);
    assertThat(time.waiting()).as("only the history's own tasks").isLessThanOrEqualTo(1);
  }

  @Test
  void everyVelocityRestartsTheCommandTimeout() throws Exception {
    CommandKey key = key();
    for (int i = 0; i < 50; i++) {
      wheels.execute(key, AHEAD);
      time.step(Duration.ofMillis(250));
    }
    assertThat(wheels.commands).hasSize(50).doesNotContain("halt");
    time.step(Duration.ofMillis(50).minusNanos(1));
    assertThat(wheels.commands).doesNotContain("halt");
    time.step(Duration.ofNanos(1));
    assertThat(wheels.commands).endsWith("halt");
  }

  @Test
  void standingWheelsAreNotWatched() throws Exception {
    CommandKey key = key();
    wheels.execute(key, AHEAD);
    wheels.execute(key, Velocity.ZERO);
    time.step(Duration.ofSeconds(1));
    assertThat(wheels.commands).containsExactly("turn 0.5 0.0", "turn 0.0 0.0");
    assertThat(wheels.driveState().commandTimeouts()).isZero();
  }

  @Test
  void aShorterSilenceCountsAtOnce() throws Exception {
    wheels.execute(key(), AHEAD);
    time.step(Duration.ofMillis(100));
    wheels.setParameter("command_timeout", "0.2");
    time.step(Duration.ofMillis(100).minusNanos(1));
    assertThat(wheels.commands).doesNotContain("halt");
    time.step(Duration.ofNanos(1));
    assertThat(wheels.commands).endsWith("halt");
  }

  @Test
  void theOldNameOfAParameterCanStillBeSet() {
    wheels.setParameter("longest_silence", "0.2");
    assertThat(wheels.parameters())
        .anyMatch(each -> each.name().equals("command_timeout") && each.value().equals("0.2"))
        .noneMatch(each -> each.name().equals("longest_silence"));
  }

  @Test
  void aSilenceThatIsOverByTheNewMeasureHaltsAtOnce() throws Exception {
    wheels.execute(key(), AHEAD);
    time.step(Duration.ofMillis(200));
    wheels.setParameter("command_timeout", "0.1");
    time.step(Duration.ZERO);
    assertThat(wheels.commands).endsWith("halt");
  }

  @ParameterizedTest
  @CsvSource({
    "0.5, 1, 0.5, 1", // all as wanted
    "2, 0, 1, 0",
    "-2, 1, -1, 0.5", // half as fast, the same curve
    "0.5, -4, 0.25, -2",
    "3, 3, 1, 1",
    "10, 40, 0.5, 2",
    "1e-9, 0, 1e-9, 0",
  })
  void limitsKeepTheCurve(double speed, double turnRate, double most, double mostTurn)
      throws Exception {
    wheels.execute(key(), new Velocity(speed, turnRate));
    Velocity got = wheels.driveState().velocity();
    assertThat(got.speed()).isCloseTo(most, within(1e-12));
    assertThat(got.yawRate()).isCloseTo(mostTurn, within(1e-12));
    assertThat(got.yawRate() * speed).as("radius").isCloseTo(got.speed() * turnRate, within(1e-9));
    assertThat(wheels.commands).containsExactly("turn " + got.speed() + " " + got.yawRate());
  }

  @Test
  void limitsCanBeSetWhileItRunsButNotAboveWhatItCan() throws Exception {
    CommandKey key = key();
    wheels.setParameter("max_speed", "0.2");
    wheels.execute(key, new Velocity(1, 1));
    assertThat(wheels.driveState().velocity()).isEqualTo(new Velocity(0.2, 0.2));
    assertThat(wheels.attributes()).contains(new DriveAttributes(0.2, 2, 0.78, 0.64));
    assertThatThrownBy(() -> wheels.setParameter("max_speed", "1.5"))
        .hasMessageContaining("which is not a number from 0.01 to 1 m/s");
    assertThatThrownBy(() -> wheels.setParameter("command_timeout", "0.4"))
        .hasMessageContaining("which is not a number from 0.05 to 0.35 s");
  }

  @Test
  void whatItNeedsForBrakingLimitsTheSilence() {
    assertThatThrownBy(() -> new ScriptedWheels(time, Map.of("command_timeout", "0.36")))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("command_timeout is \"0.36\", which is not a number from 0.05 to");
    assertThatThrownBy(() -> new ScriptedWheels(time, Map.of(), 0.46))
        .hasMessage(
            "atrv1/wheels needs 0.46 s to stop, more than 0.45 s; brake harder or drive"
                + " slower");
    try (ScriptedWheels heavy = new ScriptedWheels(time, Map.of(), 0.4)) {
      assertThat(heavy.parameters())
          .anyMatch(each -> each.name().equals("command_timeout") && each.value().equals("0.1"));
    }
  }

  @Test
  void refusesToMoveWithItsBrakeSet() throws Exception {
    CommandKey key = key();
    wheels.execute(key, AHEAD);
    wheels.execute(key, new Brake(true));
    assertThat(wheels.driveState().parkingBrakeEngaged()).isTrue();
    assertThat(wheels.driveState().velocity()).isEqualTo(Velocity.ZERO);
    assertThatThrownBy(() -> wheels.execute(key, AHEAD))
        .isInstanceOf(BrakeEngagedException.class)
        .hasMessage("atrv1/wheels has its brake set, and does not move until that is released");
    wheels.execute(key, Velocity.ZERO);
    wheels.execute(key, new Brake(false));
    wheels.execute(key, AHEAD);
    assertThat(wheels.commands)
        .containsExactly(
            "turn 0.5 0.0", "halt", "brake true", "turn 0.0 0.0", "brake false", "turn 0.5 0.0");
  }

  @Test
  void aBrakeThatSomebodySetHaltsItAndOneThatIsReleasedDoesNotDriveIt() throws Exception {
    CommandKey key = key();
    wheels.execute(key, AHEAD);
    wheels.switched(true);
    assertThat(wheels.commands).endsWith("halt");
    assertThatThrownBy(() -> wheels.execute(key, AHEAD)).hasMessageContaining("brake set");
    wheels.switched(false);
    assertThat(wheels.commands).containsExactly("turn 0.5 0.0", "halt");
    time.step(Duration.ofSeconds(1));
    assertThat(wheels.driveState().commandTimeouts()).isZero();
  }

  @Test
  void restsWhenItsCommanderLetsGo() throws Exception {
    try (CommandLease lease = wheels.acquireCommandLease(LEASE)) {
      wheels.execute(lease.key(), AHEAD);
      assertThat(wheels.driveState().commander()).isEqualTo("a module in its own virtual machine");
      lease.close();
      lease.close();
      assertThat(lease.isLive()).isFalse();
      assertThat(wheels.commands).containsExactly("turn 0.5 0.0", "halt");
      assertThat(wheels.driveState().commander()).isNull();
      assertThatThrownBy(() -> wheels.execute(lease.key(), AHEAD))
          .isInstanceOf(CommandRefusedException.class);
    }
  }

  @Test
  void restsWhenItsCommanderIsRevoked() throws Exception {
    CommandLease lease = wheels.acquireCommandLease(LEASE);
    wheels.execute(lease.key(), AHEAD);
    assertThat(wheels.leases().revoke(wheels.leases().leases().get(0).handle())).isTrue();
    assertThat(wheels.commands).endsWith("halt");
    assertThat(lease.isLive()).isFalse();
    try (CommandLease next = wheels.acquireCommandLease(LEASE)) {
      lease.close();
      assertThat(next.isLive()).as("the old one's close does not concern it").isTrue();
      wheels.execute(next.key(), AHEAD);
    }
  }

  @Test
  void restsBeforeItsDeviceIsClosed() throws Exception {
    wheels.execute(key(), AHEAD);
    wheels.close();
    assertThat(wheels.commands).containsExactly("turn 0.5 0.0", "halt", "closed");
  }

  @Test
  void aDriverThatCannotHaltIsClosedAllTheSameAndItIsRemembered() throws Exception {
    wheels.execute(key(), AHEAD);
    wheels.haltFails = new IllegalStateException("no such wire");
    wheels.close();
    assertThat(wheels.commands).containsExactly("turn 0.5 0.0", "halt", "closed");
    assertThat(wheels.history().recent())
        .anyMatch(
            each ->
                each.kind() == Incident.Kind.EXCEPTION
                    && each.description().contains("no such wire"));
  }

  @Test
  void aVelocityThatFailsHalfwayHaltsTheWheels() throws Exception {
    CommandKey key = key();
    wheels.cycleFails = new IllegalStateException("the line is full");
    assertThatThrownBy(() -> wheels.execute(key, AHEAD)).hasMessage("the line is full");
    assertThat(wheels.commands).containsExactly("turn 0.5 0.0", "halt");
    assertThat(wheels.driveState().velocity()).isEqualTo(Velocity.ZERO);
  }

  @Test
  void executesNothingWhileItDoesNotServe() throws Exception {
    CommandKey key = key();
    wheels.execute(key, AHEAD);
    wheels.restart(true);
    assertThatThrownBy(() -> wheels.execute(key, AHEAD))
        .isInstanceOf(NotReadyException.class)
        .hasMessageStartingWith("atrv1/wheels is INITIALIZING: it cannot execute Velocity[");
    assertThat(wheels.driveState().velocity()).isEqualTo(Velocity.ZERO);
    time.step(Duration.ofSeconds(1));
    assertThat(wheels.commands)
        .as("there is no controller to command")
        .containsExactly("turn 0.5 0.0");
    wheels.serveAgain();
    assertThatThrownBy(() -> wheels.execute(key, AHEAD)).hasMessageContaining("brake set");
    wheels.execute(key, new Brake(false));
    wheels.execute(key, AHEAD);
    assertThat(wheels.commands).containsExactly("turn 0.5 0.0", "brake false", "turn 0.5 0.0");
  }

  @Test
  void aKeyFromBeforeItsEndIsWorthNothing() throws Exception {
    CommandKey key = key();
    wheels.close();
    assertThatThrownBy(() -> wheels.execute(key, AHEAD))
        .isInstanceOf(CommandRefusedException.class);
    assertThatThrownBy(() -> wheels.acquireCommandLease(LEASE))
        .isInstanceOf(LeaseRefusedException.class);
    assertThat(wheels.commands).containsExactly("halt", "closed");
  }

  @Test
  void grantsNoLongerLeaseThanItsModule() {
    assertThatThrownBy(() -> wheels.acquireCommandLease(Duration.ofMinutes(5)))
        .isInstanceOf(LeaseRefusedException.class)
        .hasMessage("atrv1/wheels: lease 300 s > longest allowed 30 s; ask for 30 s or less");
    assertThatThrownBy(() -> wheels.execute(new CommandKey(UUID.randomUUID()), Velocity.ZERO))
        .as("not even to stand")
        .isInstanceOf(CommandRefusedException.class);
  }
}
