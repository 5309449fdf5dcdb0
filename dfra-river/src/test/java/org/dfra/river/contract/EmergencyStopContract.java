package org.dfra.river.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.dfra.core.config.Parameters;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.ModuleEvent.IncidentRecorded;
import org.dfra.event.Subscription;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.CommandRefusedByEmergencyStopException;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.flow.effector.LeaseRefusedByEmergencyStopException;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lifecycle.Incident;
import org.dfra.persona.EmergencyStopAttributes;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What every effector guarantees to a client that stops it for an emergency, wherever it runs. */
@Timeout(60)
abstract class EmergencyStopContract {

  static final String PATH = "atrv1/drive";

  /** Of the driver: so short that its {@link HeldScheduler} holds it. */
  static final Parameters PARAMETERS = Parameters.of(PATH, Map.of("command_timeout", "0.05"));

  static final Duration LEASE = Duration.ofSeconds(10);
  static final Duration PATIENCE = Duration.ofSeconds(20);
  static final Velocity AHEAD = new Velocity(0.5, -0.25);
  static final String TURNED = "turn 0.5 -0.25";

  /** The effector, as its client holds it. */
  abstract DriveEffector effector();

  /** Its driver. */
  abstract ScriptedDrive driver();

  /** Ends the module. */
  abstract void end();

  /** How a commander is called that asks in this way. */
  abstract String commander();

  /** Stops it, and waits for what a busy machine may not get done in half a second. */
  private EmergencyStopState stop(String by) throws Exception {
    assertThat(effector().emergencyStop(by).latched()).isTrue();
    await().atMost(PATIENCE).until(() -> effector().emergencyStopState().haltCommanded());
    return effector().emergencyStopState();
  }

  @Test
  void anEmergencyStopHaltsTheWheelsAndItsCommanderHasLostThem() throws Exception {
    CommandLease lease = effector().acquireCommandLease(LEASE);
    effector().execute(lease.key(), AHEAD);
    EmergencyStopState stopped = stop("ops");
    assertThat(driver().commands).containsExactly(TURNED, "halt");
    assertThat(stopped.requester()).isEqualTo("ops");
    assertThat(stopped.since()).isBeforeOrEqualTo(java.time.Instant.now());
    assertThat(stopped.age()).as("how long ago, by time that nobody sets").isNotNull();
    assertThat(stopped.fault()).isNull();
    assertThat(effector().driveState().commander()).isNull();
    assertThat(driver().leases().leases()).isEmpty();
    await().atMost(PATIENCE).until(() -> !lease.isLive());
    String sentence =
        PATH
            + " is stopped for an emergency since "
            + stopped.since()
            + ", by ops, and executes no commands; when it is safe, release it: ./dfra stop"
            + " --release atrv1";
    assertThatThrownBy(() -> effector().execute(lease.key(), AHEAD))
        .isInstanceOf(CommandRefusedByEmergencyStopException.class)
        .hasMessage(sentence);
    assertThatThrownBy(() -> effector().acquireCommandLease(LEASE))
        .isInstanceOf(LeaseRefusedByEmergencyStopException.class)
        .hasMessage(sentence);
    assertThat(driver().commands).containsExactly(TURNED, "halt");
  }

  @Test
  void itsCommanderLearnsOfTheStopAlsoAfterItsRelease() throws Exception {
    CommandLease lease = effector().acquireCommandLease(LEASE);
    stop("ops");
    effector().releaseEmergencyStop("the chief");
    assertThatThrownBy(() -> effector().execute(lease.key(), AHEAD))
        .isInstanceOf(CommandRefusedByEmergencyStopException.class)
        .hasMessage(
            PATH
                + " was stopped for an emergency while this key commanded it, and was released"
                + " since; to move it again, request a new command lease");
    assertThat(driver().commands).containsExactly("halt");
  }

  @Test
  void staysStoppedUntilItIsReleasedAndDoesNotMoveByThat() throws Exception {
    assertThat(effector().emergencyStopState()).isEqualTo(EmergencyStopState.NEVER);
    assertThat(effector().releaseEmergencyStop("ops"))
        .as("nothing to release")
        .isEqualTo(EmergencyStopState.NEVER);
    EmergencyStopState first = stop("ops");
    assertThat(stop("another")).as("who was first is kept").isEqualTo(first);
    driver().commands.clear();
    EmergencyStopState released = effector().releaseEmergencyStop("the chief");
    assertThat(released.latched()).isFalse();
    assertThat(released.requester()).isEqualTo("the chief");
    assertThat(effector().emergencyStopState()).isEqualTo(released);
    assertThat(driver().commands).isEmpty();
    try (CommandLease lease = effector().acquireCommandLease(LEASE)) {
      effector().execute(lease.key(), AHEAD);
      assertThat(driver().commands).containsExactly(TURNED);
    }
  }

  /** A name as it may come with a stop, and what is kept of it. */
  private record Name(@Nullable String given, String kept) {}

  @Test
  void isStoppedAndReleasedWhateverNameComesWithIt() throws Exception {
    String longerThanAnyRequest = "x".repeat(10_000_000);
    List<Name> names =
        List.of(
            new Name(null, "somebody"),
            new Name(" \u0000\u202e\u2028\ud800\n", "somebody"),
            new Name("ops\u0007\r\nat home", "ops at home"),
            new Name(longerThanAnyRequest, "x".repeat(120) + "…"));
    for (Name name : names) {
      driver().commands.clear();
      EmergencyStopState stopped = effector().emergencyStop(name.given());
      assertThat(stopped.latched()).as(name.kept()).isTrue();
      assertThat(stopped.requester()).isEqualTo(name.kept());
      await().atMost(PATIENCE).until(() -> effector().emergencyStopState().haltCommanded());
      assertThat(driver().commands).as(name.kept()).containsExactly("halt");
      EmergencyStopState released = effector().releaseEmergencyStop(name.given());
      assertThat(released.latched()).as(name.kept()).isFalse();
      assertThat(released.requester()).isEqualTo(name.kept());
    }
  }

  @Test
  void isStoppedAlsoWhileItDoesNotServe() throws Exception {
    driver().lose();
    assertThat(stop("ops").latched()).isTrue();
    assertThat(driver().commands).containsExactly("halt");
    assertThatThrownBy(() -> effector().acquireCommandLease(LEASE))
        .isInstanceOf(LeaseRefusedException.class)
        .hasMessageContaining("is stopped for an emergency");
  }

  @Test
  void reportsThatItIsStoppedAndReleased() throws Exception {
    List<Incident> received = new CopyOnWriteArrayList<>();
    try (Subscription unused =
        effector()
            .subscribe(
                delivery -> {
                  if (delivery.event() instanceof IncidentRecorded noted) {
                    received.add(noted.incident());
                  }
                },
                DeliveryPolicy.keepLast(100).withKinds(EventKind.INCIDENT))) {
      EmergencyStopState stopped = stop("ops");
      assertThat(driver().attributes())
          .contains(new EmergencyStopAttributes(true, "ops", stopped.since()));
      effector().releaseEmergencyStop("the chief");
      await().atMost(PATIENCE).until(() -> received.size() >= 2);
    }
    assertThat(received)
        .extracting(Incident::kind)
        .containsExactly(Incident.Kind.EMERGENCY_STOP, Incident.Kind.RELEASE);
    assertThat(received)
        .extracting(Incident::description)
        .containsExactly(
            "it was stopped for an emergency, by ops",
            "it was released from its emergency stop, by the chief");
    assertThat(effector().history().recent()).containsAll(received);
  }

  @Test
  void getsThroughWhileACommandIsHeldUpInTheDriver() throws Exception {
    CommandLease lease = effector().acquireCommandLease(LEASE);
    CountDownLatch holder = new CountDownLatch(1);
    driver().cycleHeldUp = holder;
    CompletableFuture<Void> heldUp = CompletableFuture.runAsync(() -> commandOn(lease.key()));
    try {
      await().atMost(PATIENCE).until(() -> !driver().commands.isEmpty());
      EmergencyStopState stopped = effector().emergencyStop("ops");
      assertThat(stopped.latched()).isTrue();
      assertThat(stopped.haltCommanded()).isFalse();
      assertThat(stopped.fault()).startsWith("its driver is blocked");
      await().atMost(PATIENCE).until(() -> driver().commands.contains("halt"));
      assertThatThrownBy(() -> effector().acquireCommandLease(LEASE))
          .isInstanceOf(LeaseRefusedException.class);
    } finally {
      holder.countDown();
    }
    heldUp.get(20, TimeUnit.SECONDS);
    await().atMost(PATIENCE).until(() -> effector().emergencyStopState().haltCommanded());
    assertThat(driver().commands).startsWith("turn 0.9 0.0", "halt", "halt");
    assertThat(driver().commands.subList(1, driver().commands.size()))
        .as("a command that returns too late is halted for that as well")
        .containsOnly("halt");
  }

  /** Until it is refused. */
  void commandOn(CommandKey key) {
    try {
      while (true) {
        effector().execute(key, new Velocity(0.9, 0));
      }
    } catch (CommandRefusedException e) {
      // its time is over
    } catch (RemoteException e) {
      throw new AssertionError(e);
    }
  }
}
