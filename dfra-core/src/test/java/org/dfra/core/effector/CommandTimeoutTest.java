package org.dfra.core.effector;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.LeaseRole;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Two drives in one virtual machine, by real time. The driver of the first is held up in a write.
 */
@Timeout(120)
class CommandTimeoutTest {

  private static final Duration PATIENCE = Duration.ofSeconds(20);
  private static final Duration LEASE = Duration.ofSeconds(30);

  /** The command time-out's 0.3 s; 50 ms for the timer, the write and this test's own look. */
  private static final Duration HALTED = Duration.ofMillis(350);

  private static final Velocity AHEAD = new Velocity(0.5, 0);
  private static final Velocity LATER = new Velocity(0.7, 0);
  private static final String TURNED = "turn 0.5 0.0";

  private final ScriptedWheels heldUp = new ScriptedWheels(Scheduler.system(), Map.of());
  private final ScriptedWheels other = new ScriptedWheels(Scheduler.system(), Map.of());
  private final CountDownLatch write = new CountDownLatch(1);

  @BeforeEach
  void begin() {
    heldUp.start();
    other.start();
  }

  @AfterEach
  void end() {
    write.countDown();
    heldUp.close();
    other.close();
  }

  private CompletableFuture<Void> holdUp(CommandKey key) {
    heldUp.cycleHeldUp = write;
    CompletableFuture<Void> writing = command(key, AHEAD);
    await().atMost(PATIENCE).until(() -> heldUp.commands.contains(TURNED));
    return writing;
  }

  private CompletableFuture<Void> command(CommandKey key, Velocity velocity) {
    return CompletableFuture.runAsync(
        () -> heldUp.execute(key, velocity), task -> new Thread(task).start());
  }

  @Test
  void aDriverThatIsHeldUpDoesNotDelayTheTimeoutOfAnother() throws Exception {
    CompletableFuture<Void> writing = holdUp(heldUp.acquireCommandLease(LEASE).key());
    CommandKey key = other.acquireCommandLease(LEASE).key();
    try (StallProbe probe = StallProbe.start()) {
      other.execute(key, AHEAD);
      StallProbe.Stopwatch begun = probe.stopwatch();
      await()
          .pollInterval(Duration.ofMillis(5))
          .atMost(PATIENCE)
          .until(() -> other.commands.contains("halt"));
      Timing halted = begun.stop();
      assertThat(writing).as("the first is held up all the while").isNotDone();
      assertThat(other.driveState().commandTimeouts()).isEqualTo(1);
      halted.requireWithin("the halt after the last velocity", HALTED);
    }
  }

  @Test
  void aDriverThatIsHeldUpIsHaltedPastItsWriteAndBeforeItExecutesAnythingLater() throws Exception {
    CommandKey key = heldUp.acquireCommandLease(LEASE).key();
    CompletableFuture<Void> writing = holdUp(key);
    CompletableFuture<Void> waiting = command(key, LATER);
    long asked = System.nanoTime();
    await().atMost(PATIENCE).until(() -> heldUp.commands.contains("halt"));
    assertThat(writing).isNotDone();
    await()
        .atMost(PATIENCE)
        .until(() -> System.nanoTime() - asked > TimeUnit.MILLISECONDS.toNanos(500));
    heldUp.cycleHeldUp = null;
    write.countDown();
    writing.get(20, TimeUnit.SECONDS);
    assertThatThrownBy(() -> waiting.get(20, TimeUnit.SECONDS))
        .as("its sender gave up on it long ago")
        .isInstanceOf(ExecutionException.class)
        .hasCauseInstanceOf(CommandRefusedException.class)
        .hasMessageContaining("was held up by an earlier command for ")
        .hasMessageContaining("is too old and was not executed");
    assertThat(heldUp.commands.subList(0, 3)).containsExactly(TURNED, "halt", "halt");
    assertThat(heldUp.commands).doesNotContain("turn 0.7 0.0");
    assertThat(heldUp.driveState().velocity()).isEqualTo(Velocity.ZERO);
    heldUp.execute(key, LATER);
    assertThat(heldUp.commands).as("what is fresh is executed").contains("turn 0.7 0.0");
  }

  @Test
  void anotherIsStoppedForAnEmergencyWhileADriverIsHeldUp() throws Exception {
    CompletableFuture<Void> writing = holdUp(heldUp.acquireCommandLease(LEASE).key());
    await().atMost(PATIENCE).until(() -> heldUp.commands.contains("halt")); // its time-out has come
    other.execute(other.acquireCommandLease(LEASE).key(), AHEAD);
    EmergencyStopState stopped = other.emergencyStop("a test");
    assertThat(stopped.haltCommanded()).isTrue();
    assertThat(other.commands).contains("halt");
    assertThat(writing).isNotDone();
  }

  @Test
  void theEndOfALeaseOnADriverThatIsHeldUpHoldsUpNoTimer() throws Exception {
    CommandKey key = heldUp.commandArbiter().acquire("a test", over -> grant(over));
    CompletableFuture<Void> writing = holdUp(key);
    await().atMost(PATIENCE).until(() -> heldUp.commands.contains("halt"));
    CountDownLatch timer = new CountDownLatch(1);
    Object unused =
        Scheduler.system().after(TimeUnit.SECONDS.toNanos(3), timer::countDown); // after its end
    assertThat(timer.await(20, TimeUnit.SECONDS)).as("the timer of all others runs on").isTrue();
    assertThat(writing).isNotDone();
    assertThat(heldUp.commandArbiter().commander())
        .as("it is not over before it rests")
        .isNotNull();
    write.countDown();
    writing.get(20, TimeUnit.SECONDS);
    await().atMost(PATIENCE).until(() -> heldUp.commandArbiter().commander() == null);
  }

  /** Long enough for the write to begin and its time-out to come first, on a busy computer too. */
  private java.util.UUID grant(Runnable over) throws LeaseRefusedException {
    return heldUp.leases().grant(Duration.ofSeconds(2), LeaseRole.COMMANDER, null, over).id();
  }
}
