package org.dfra.core.effector;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.dfra.core.effector.StopLatchTest.FullDisk;
import org.dfra.core.state.StateStore;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.StopState;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.module.Incident;
import org.dfra.persona.StopAttributes;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What an emergency stop does to a driver, above all to one that is held up. */
@Timeout(60)
class EmergencyStopTest {

  private static final Duration LEASE = Duration.ofSeconds(30);
  private static final Duration PATIENCE = Duration.ofSeconds(20);
  private static final Velocity AHEAD = new Velocity(0.5, 0);
  private static final String TURNED = "turn 0.5 0.0";
  private static final int ROUNDS = Boolean.getBoolean("dfra.full") ? 3000 : 200;

  private final StateStore state = StateStore.inMemory();
  private ScriptedWheels wheels = wheels(state);

  /** Their silence is long, so that no halt is the silence's. */
  private static ScriptedWheels wheels(StateStore state) {
    ScriptedWheels made =
        new ScriptedWheels(new org.dfra.core.lease.SteppedScheduler(), Map.of(), 0.15, state);
    made.start();
    return made;
  }

  @AfterEach
  void close() {
    CountDownLatch holder = wheels.turnHeldUp;
    if (holder != null) {
      holder.countDown();
    }
    wheels.close();
  }

  private List<Incident.Kind> noted() {
    return wheels.history().recent().stream().map(Incident::kind).toList();
  }

  /** Stops them, and waits for what a busy machine may not get done in half a second. */
  private static StopState stop(ScriptedWheels wheels, String by) {
    StopState now = wheels.emergencyStop(by);
    if (now.resting()) { // as it is thousands of times here, and looking again takes a while
      return now;
    }
    await().atMost(PATIENCE).until(() -> wheels.stopState().resting());
    return wheels.stopState();
  }

  @Test
  void haltsTheWheelsAlsoWhereNobodyCommands() {
    StopState stopped = stop(wheels, "ops");
    assertThat(stopped.latched()).isTrue();
    assertThat(stopped.fault()).isNull();
    assertThat(wheels.told).containsExactly("halt");
    stop(wheels, "another");
    assertThat(wheels.told).as("once more does no harm").containsExactly("halt", "halt");
    assertThat(wheels.stopState()).isEqualTo(stopped);
    assertThat(noted()).containsExactly(Incident.Kind.ACTIVATION, Incident.Kind.EMERGENCY_STOP);
  }

  @Test
  void haltsTheWheelsAlsoWhereNobodyIsNamed() {
    assertThat(wheels.emergencyStop(null).latched()).isTrue();
    await().atMost(PATIENCE).until(() -> wheels.stopState().resting());
    assertThat(wheels.told).containsExactly("halt");
    assertThat(wheels.stopState().by()).isEqualTo("somebody");
    assertThat(StopLatch.kept(state).latched()).as("of the next life").isTrue();
  }

  @Test
  void getsThroughWhileACommandIsHeldUpInTheDriver() throws Exception {
    CommandLease lease = wheels.command(LEASE);
    CountDownLatch holder = new CountDownLatch(1);
    wheels.turnHeldUp = holder;
    CompletableFuture<Void> heldUp =
        CompletableFuture.runAsync(() -> wheels.obey(lease.key(), AHEAD));
    await().atMost(PATIENCE).until(() -> wheels.told.contains(TURNED));

    StopState stopped = wheels.emergencyStop("ops");
    assertThat(stopped.latched()).isTrue();
    assertThat(stopped.resting()).isFalse();
    assertThat(stopped.fault())
        .isEqualTo("its driver is held up, and comes to rest as soon as it goes on");
    assertThat(wheels.told)
        .as("the wheels are halted all the same")
        .containsExactly(TURNED, "halt");
    assertThat(StopLatch.kept(state).latched()).as("of the next life").isTrue();
    assertThat(lease.isLive()).isFalse();
    assertThatThrownBy(() -> wheels.obey(lease.key(), AHEAD))
        .isInstanceOf(CommandRefusedException.class)
        .hasMessageContaining("is stopped for an emergency since");
    assertThatThrownBy(() -> wheels.command(LEASE)).isInstanceOf(LeaseRefusedException.class);
    assertThat(wheels.emergencyStop("another").resting()).isFalse();

    holder.countDown();
    heldUp.get(20, TimeUnit.SECONDS);
    await().atMost(PATIENCE).until(() -> wheels.stopState().resting());
    assertThat(wheels.told).as("and once more").containsExactly(TURNED, "halt", "halt");
    assertThat(wheels.drive().velocity()).isEqualTo(Velocity.ZERO);
  }

  @Test
  void aDriverThatCannotBeToldIsLatchedAndSaysSo() {
    wheels.haltFails = new IllegalStateException("no such wire");
    StopState unused = wheels.emergencyStop("ops");
    await().atMost(PATIENCE).until(() -> fault().contains("no such wire"));
    StopState stopped = wheels.stopState();
    assertThat(stopped.latched()).isTrue();
    assertThat(stopped.resting()).isFalse();
    assertThat(stopped.fault())
        .isEqualTo(
            "its driver could not be told to come to rest (java.lang.IllegalStateException: no such"
                + " wire); switch it off by hand");
    assertThat(StopLatch.kept(state).latched()).isTrue();
    wheels.haltFails = null;
    assertThat(stop(wheels, "ops").fault()).as("tried once more").isNull();
  }

  private String fault() {
    return String.valueOf(wheels.stopState().fault());
  }

  @Test
  void aFullDiskKeepsNobodyFromStopping() {
    FullDisk disk = new FullDisk();
    ScriptedWheels others = wheels(disk);
    try {
      StopState stopped = stop(others, "ops");
      assertThat(stopped.latched()).isTrue();
      assertThat(stopped.fault()).contains("No space left on device");
      assertThat(others.told).containsExactly("halt");
      assertThatThrownBy(() -> others.command(LEASE)).isInstanceOf(LeaseRefusedException.class);
      assertThat(others.history().recent())
          .anyMatch(
              each ->
                  each.kind() == Incident.Kind.EXCEPTION
                      && each.what().contains("the next life of this module would not know"));
      disk.full = false;
      assertThat(others.emergencyStop("ops").fault()).as("written at last").isNull();
    } finally {
      others.close();
    }
  }

  @Test
  void aNextLifeBeginsStoppedAndObeysOnceItIsReleased() throws Exception {
    wheels.emergencyStop("ops");
    wheels.close();
    wheels = wheels(state);
    assertThat(wheels.stopState().by()).isEqualTo("ops");
    assertThat(wheels.attributes()).contains(new StopAttributes(true, "ops", stoppedAt()));
    assertThatThrownBy(() -> wheels.command(LEASE)).isInstanceOf(LeaseRefusedException.class);
    assertThat(wheels.releaseStop("the chief").latched()).isFalse();
    assertThat(wheels.told).as("releasing moves nothing").isEmpty();
    assertThat(noted()).endsWith(Incident.Kind.RELEASE);
    try (CommandLease lease = wheels.command(LEASE)) {
      wheels.obey(lease.key(), AHEAD);
      assertThat(wheels.told).containsExactly(TURNED);
    }
    wheels.releaseStop("another");
    assertThat(wheels.stopState().by()).as("there was nothing to release").isEqualTo("the chief");
  }

  private java.time.Instant stoppedAt() {
    return java.util.Objects.requireNonNull(wheels.stopState().since());
  }

  @Test
  void holdsWhileTheDeviceDoesNotServeAndOnceItDoes() {
    wheels.restart(false);
    assertThat(stop(wheels, "ops").fault()).isNull();
    wheels.serveAgain();
    assertThatThrownBy(() -> wheels.command(LEASE)).isInstanceOf(LeaseRefusedException.class);
  }

  @Test
  void oneThatHasEndedIsLatchedForItsNextLifeAndItsHistoryStaysAsItWas() {
    wheels.close();
    wheels.emergencyStop("ops");
    assertThat(noted()).endsWith(Incident.Kind.DEACTIVATION);
    wheels = wheels(state);
    assertThat(wheels.stopState().latched()).isTrue();
    assertThat(wheels.history().failures()).isZero();
  }

  @Test
  void whoeverIsInterruptedStopsItAllTheSame() {
    Thread.currentThread().interrupt();
    StopState unused = wheels.emergencyStop("ops");
    assertThat(Thread.interrupted()).as("it is still to be interrupted").isTrue();
    await().atMost(PATIENCE).until(() -> wheels.stopState().resting());
    assertThat(StopLatch.kept(state).latched()).isTrue();
  }

  @Test
  void noCommandIsObeyedOnceItIsStopped() throws Exception {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    ScriptedWheels busy = new ScriptedWheels(Scheduler.system(), Map.of());
    busy.start();
    try {
      for (int round = 0; round < ROUNDS; round++) {
        String which = "-Ddfra.seed=" + seed + ", round " + round;
        busy.told.clear();
        CompletableFuture<Void> commanding = CompletableFuture.runAsync(() -> commandOn(busy));
        for (int i = random.nextInt(2000); i > 0; i--) {
          Thread.onSpinWait();
        }
        assertThat(stop(busy, "ops").latched()).as(which).isTrue();
        int size = busy.told.size(); // whatever comes now would be obeyed while it is stopped
        assertThat(busy.told.get(size - 1)).as(which).isEqualTo("halt");
        commanding.get(20, TimeUnit.SECONDS);
        assertThat(busy.told).as(which).hasSize(size);
        assertThat(busy.leases().leases()).as(which).isEmpty();
        busy.releaseStop("ops");
      }
    } finally {
      busy.close();
    }
  }

  /** Takes command and drives, until it is refused. */
  private static void commandOn(ScriptedWheels wheels) {
    try {
      CommandLease lease = wheels.command(LEASE);
      while (true) {
        wheels.obey(lease.key(), AHEAD);
      }
    } catch (LeaseRefusedException | CommandRefusedException e) {
      // it is stopped
    }
  }
}
