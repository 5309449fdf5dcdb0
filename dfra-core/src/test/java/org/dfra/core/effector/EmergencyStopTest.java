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
import org.dfra.core.effector.EmergencyStopLatchTest.FullDisk;
import org.dfra.core.state.StateStore;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lifecycle.Incident;
import org.dfra.persona.EmergencyStopAttributes;
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
    CountDownLatch holder = wheels.cycleHeldUp;
    if (holder != null) {
      holder.countDown();
    }
    wheels.close();
  }

  private List<Incident.Kind> noted() {
    return wheels.history().recent().stream().map(Incident::kind).toList();
  }

  /** Stops them, and waits for what a busy machine may not get done in half a second. */
  private static EmergencyStopState stop(ScriptedWheels wheels, String by) {
    EmergencyStopState now = wheels.emergencyStop(by);
    if (now.haltCommanded()) { // as it is thousands of times here, and polling takes a while
      return now;
    }
    await().atMost(PATIENCE).until(() -> wheels.emergencyStopState().haltCommanded());
    return wheels.emergencyStopState();
  }

  @Test
  void haltsTheWheelsAlsoWhereNobodyCommands() {
    EmergencyStopState stopped = stop(wheels, "ops");
    assertThat(stopped.latched()).isTrue();
    assertThat(stopped.fault()).isNull();
    assertThat(wheels.commands).containsExactly("halt");
    stop(wheels, "another");
    assertThat(wheels.commands).as("once more does no harm").containsExactly("halt", "halt");
    assertThat(wheels.emergencyStopState()).isEqualTo(stopped);
    assertThat(noted()).containsExactly(Incident.Kind.ACTIVATION, Incident.Kind.EMERGENCY_STOP);
  }

  @Test
  void haltsTheWheelsAlsoWhereNobodyIsNamed() {
    assertThat(wheels.emergencyStop(null).latched()).isTrue();
    await().atMost(PATIENCE).until(() -> wheels.emergencyStopState().haltCommanded());
    assertThat(wheels.commands).containsExactly("halt");
    assertThat(wheels.emergencyStopState().requester()).isEqualTo("somebody");
    assertThat(EmergencyStopLatch.loadState(state).latched()).as("of the next life").isTrue();
  }

  @Test
  void getsThroughWhileACommandIsHeldUpInTheDriver() throws Exception {
    CommandLease lease = wheels.acquireCommandLease(LEASE);
    CountDownLatch holder = new CountDownLatch(1);
    wheels.cycleHeldUp = holder;
    CompletableFuture<Void> heldUp =
        CompletableFuture.runAsync(() -> wheels.execute(lease.key(), AHEAD));
    await().atMost(PATIENCE).until(() -> wheels.commands.contains(TURNED));

    EmergencyStopState stopped = wheels.emergencyStop("ops");
    assertThat(stopped.latched()).isTrue();
    assertThat(stopped.haltCommanded()).isFalse();
    assertThat(stopped.fault())
        .isEqualTo("its driver is blocked, and stops as soon as it continues");
    assertThat(wheels.commands)
        .as("the wheels are halted all the same")
        .containsExactly(TURNED, "halt");
    assertThat(EmergencyStopLatch.loadState(state).latched()).as("of the next life").isTrue();
    assertThat(lease.isLive()).isFalse();
    assertThatThrownBy(() -> wheels.execute(lease.key(), AHEAD))
        .isInstanceOf(CommandRefusedException.class)
        .hasMessageContaining("is stopped for an emergency since");
    assertThatThrownBy(() -> wheels.acquireCommandLease(LEASE))
        .isInstanceOf(LeaseRefusedException.class);
    assertThat(wheels.emergencyStop("another").haltCommanded()).isFalse();

    holder.countDown();
    heldUp.get(20, TimeUnit.SECONDS);
    await().atMost(PATIENCE).until(() -> wheels.emergencyStopState().haltCommanded());
    assertThat(wheels.commands).as("and once more").containsExactly(TURNED, "halt", "halt");
    assertThat(wheels.driveState().velocity()).isEqualTo(Velocity.ZERO);
  }

  @Test
  void aDriverThatCannotBeHaltedIsLatchedAndReportsIt() {
    wheels.haltFails = new IllegalStateException("no such wire");
    EmergencyStopState unused = wheels.emergencyStop("ops");
    await().atMost(PATIENCE).until(() -> fault().contains("no such wire"));
    EmergencyStopState stopped = wheels.emergencyStopState();
    assertThat(stopped.latched()).isTrue();
    assertThat(stopped.haltCommanded()).isFalse();
    assertThat(stopped.fault())
        .isEqualTo(
            "its driver could not be stopped (java.lang.IllegalStateException: no such"
                + " wire); switch it off by hand");
    assertThat(EmergencyStopLatch.loadState(state).latched()).isTrue();
    wheels.haltFails = null;
    assertThat(stop(wheels, "ops").fault()).as("tried once more").isNull();
  }

  private String fault() {
    return String.valueOf(wheels.emergencyStopState().fault());
  }

  @Test
  void aFullDiskKeepsNobodyFromStopping() {
    FullDisk disk = new FullDisk();
    ScriptedWheels others = wheels(disk);
    try {
      EmergencyStopState stopped = stop(others, "ops");
      assertThat(stopped.latched()).isTrue();
      assertThat(stopped.fault()).contains("No space left on device");
      assertThat(others.commands).containsExactly("halt");
      assertThatThrownBy(() -> others.acquireCommandLease(LEASE))
          .isInstanceOf(LeaseRefusedException.class);
      assertThat(others.history().recent())
          .anyMatch(
              each ->
                  each.kind() == Incident.Kind.EXCEPTION
                      && each.description()
                          .contains("the module would not know of it after a restart"));
      disk.full = false;
      assertThat(others.emergencyStop("ops").fault()).as("written at last").isNull();
    } finally {
      others.close();
    }
  }

  @Test
  void theNextIncarnationStartsStoppedAndExecutesCommandsOnceItIsReleased() throws Exception {
    wheels.emergencyStop("ops");
    wheels.close();
    wheels = wheels(state);
    assertThat(wheels.emergencyStopState().requester()).isEqualTo("ops");
    assertThat(wheels.attributes()).contains(new EmergencyStopAttributes(true, "ops", stoppedAt()));
    assertThatThrownBy(() -> wheels.acquireCommandLease(LEASE))
        .isInstanceOf(LeaseRefusedException.class);
    assertThat(wheels.releaseEmergencyStop("the chief").latched()).isFalse();
    assertThat(wheels.commands).as("releasing moves nothing").isEmpty();
    assertThat(noted()).endsWith(Incident.Kind.RELEASE);
    try (CommandLease lease = wheels.acquireCommandLease(LEASE)) {
      wheels.execute(lease.key(), AHEAD);
      assertThat(wheels.commands).containsExactly(TURNED);
    }
    wheels.releaseEmergencyStop("another");
    assertThat(wheels.emergencyStopState().requester())
        .as("there was nothing to release")
        .isEqualTo("the chief");
  }

  private java.time.Instant stoppedAt() {
    return java.util.Objects.requireNonNull(wheels.emergencyStopState().since());
  }

  @Test
  void holdsWhileTheDeviceDoesNotServeAndOnceItDoes() {
    wheels.restart(false);
    assertThat(stop(wheels, "ops").fault()).isNull();
    wheels.serveAgain();
    assertThatThrownBy(() -> wheels.acquireCommandLease(LEASE))
        .isInstanceOf(LeaseRefusedException.class);
  }

  @Test
  void oneThatHasEndedIsLatchedForItsNextLifeAndItsHistoryStaysAsItWas() {
    wheels.close();
    wheels.emergencyStop("ops");
    assertThat(noted()).endsWith(Incident.Kind.DEACTIVATION);
    wheels = wheels(state);
    assertThat(wheels.emergencyStopState().latched()).isTrue();
    assertThat(wheels.history().failures()).isZero();
  }

  @Test
  void anInterruptedCallerStopsItAllTheSame() {
    Thread.currentThread().interrupt();
    EmergencyStopState unused = wheels.emergencyStop("ops");
    assertThat(Thread.interrupted()).as("it is still to be interrupted").isTrue();
    await().atMost(PATIENCE).until(() -> wheels.emergencyStopState().haltCommanded());
    assertThat(EmergencyStopLatch.loadState(state).latched()).isTrue();
  }

  @Test
  void noCommandIsExecutedOnceItIsStopped() throws Exception {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    ScriptedWheels busy = new ScriptedWheels(Scheduler.system(), Map.of());
    busy.start();
    try {
      for (int round = 0; round < ROUNDS; round++) {
        String which = "-Ddfra.seed=" + seed + ", round " + round;
        busy.commands.clear();
        CompletableFuture<Void> commanding = CompletableFuture.runAsync(() -> commandOn(busy));
        for (int i = random.nextInt(2000); i > 0; i--) {
          Thread.onSpinWait();
        }
        assertThat(stop(busy, "ops").latched()).as(which).isTrue();
        int size = busy.commands.size(); // any further one was executed while it is stopped
        assertThat(busy.commands.get(size - 1)).as(which).isEqualTo("halt");
        commanding.get(20, TimeUnit.SECONDS);
        assertThat(busy.commands).as(which).hasSize(size);
        assertThat(busy.leases().leases()).as(which).isEmpty();
        busy.releaseEmergencyStop("ops");
      }
    } finally {
      busy.close();
    }
  }

  /** Takes command and drives, until it is refused. */
  private static void commandOn(ScriptedWheels wheels) {
    try {
      CommandLease lease = wheels.acquireCommandLease(LEASE);
      while (true) {
        wheels.execute(lease.key(), AHEAD);
      }
    } catch (LeaseRefusedException | CommandRefusedException e) {
      // it is stopped
    }
  }
}
