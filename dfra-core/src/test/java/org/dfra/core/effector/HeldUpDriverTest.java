package org.dfra.core.effector;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.dfra.core.time.StallProbe;
import org.dfra.flow.effector.BrakeEngagedException;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.DriveCommand.Brake;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveState;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.LeaseRole;
import org.dfra.persona.Attributes;
import org.dfra.persona.DriveAttributes;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Nobody waits for a driver that is held up in a write or in a halt; by real time. */
@Timeout(120)
class HeldUpDriverTest {

  private static final Duration PATIENCE = Duration.ofSeconds(20);
  private static final Duration LEASE = Duration.ofSeconds(30);

  /** The command time-out's 0.3 s; 50 ms for the timer, the write and this test's own look. */
  private static final Duration HALTED = Duration.ofMillis(350);

  private static final Velocity AHEAD = new Velocity(0.5, 0);
  private static final String TURNED = "turn 0.5 0.0";

  private final ScriptedWheels wheels = new ScriptedWheels(Scheduler.system(), Map.of());
  private final CountDownLatch release = new CountDownLatch(1);

  @BeforeEach
  void begin() {
    wheels.start();
  }

  @AfterEach
  void end() {
    release.countDown();
    wheels.close();
  }

  private CommandKey key() throws LeaseRefusedException {
    return wheels.acquireCommandLease(LEASE).key();
  }

  private CompletableFuture<Void> holdUpAWrite(CommandKey key) {
    wheels.cycleHeldUp = release;
    CompletableFuture<Void> writing = beside(() -> wheels.execute(key, AHEAD));
    await().atMost(PATIENCE).until(() -> wheels.commands.contains(TURNED));
    return writing;
  }

  private static CompletableFuture<Void> beside(Runnable task) {
    return CompletableFuture.runAsync(task, run -> new Thread(run).start());
  }

  private static <T> T answer(Supplier<T> question) throws Exception {
    return CompletableFuture.supplyAsync(question, run -> new Thread(run).start())
        .get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
  }

  @Test
  void aCommanderHasAThreadThatCanHaltTheDeviceLater() throws Exception {
    Set<Thread> before = Thread.getAllStackTraces().keySet();
    wheels.execute(key(), new Brake(true)); // which no time-out follows
    Set<Thread> begun = new HashSet<>(Thread.getAllStackTraces().keySet());
    begun.removeAll(before);
    assertThat(begun).extracting(Thread::getName).contains("dfra-halts " + ScriptedWheels.PATH);
  }

  @Test
  void aDeviceWhoseDriverBlocksInAHaltIsClosed() throws Exception {
    wheels.execute(key(), AHEAD);
    wheels.haltHeldUp = release;
    beside(wheels::close).get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    assertThat(wheels.commands).containsSubsequence(TURNED, "halt", "closed");
  }

  @Test
  void aDeviceWhoseDriverBlocksInAWriteAndInAHaltIsClosed() throws Exception {
    CompletableFuture<Void> writing = holdUpAWrite(key());
    wheels.haltHeldUp = release;
    beside(wheels::close).get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    assertThat(wheels.commands).contains("closed");
    assertThat(writing).isNotDone();
  }

  @Test
  void aSecondBrakeDoesNotWaitForAHaltThatBlocks() throws Exception {
    CommandKey key = key();
    wheels.execute(key, AHEAD);
    wheels.haltHeldUp = release;
    beside(() -> wheels.switched(true)).get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    assertThat(wheels.commands).contains("halt");
    DriveState now = answer(wheels::driveState);
    assertThat(now.parkingBrakeEngaged()).isTrue();
    assertThat(now.velocity()).isEqualTo(Velocity.ZERO);
  }

  @Test
  void aBrakeThatIsFoundSetWhileAWriteHangsHaltsPastItAndOnceMoreAfterIt() throws Exception {
    wheels.setParameter("command_timeout", "0.35");
    CommandKey key = key();
    CompletableFuture<Void> writing = holdUpAWrite(key);
    beside(() -> wheels.switched(true)).get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    await().atMost(PATIENCE).until(() -> wheels.commands.contains("halt"));
    assertThat(writing).isNotDone();
    assertThat(wheels.driveState().parkingBrakeEngaged()).isTrue();
    release.countDown();
    writing.get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    await()
        .atMost(PATIENCE)
        .until(() -> wheels.commands.stream().filter("halt"::equals).count() >= 2);
    assertThatThrownBy(() -> wheels.execute(key, AHEAD)).isInstanceOf(BrakeEngagedException.class);
    assertThat(wheels.driveState().commandTimeouts()).as("the brake was first").isZero();
  }

  @Test
  void askingNeverWaitsForAWrite() throws Exception {
    CompletableFuture<Void> writing = holdUpAWrite(key());
    assertThat(answer(wheels::driveState).velocity()).isEqualTo(AHEAD);
    List<Attributes> attributes = answer(wheels::attributes);
    assertThat(attributes).contains(new DriveAttributes(1, 2, 0.78, 0.64));
    assertThat(answer(wheels::parameters)).anyMatch(each -> each.name().equals("max_speed"));
    assertThat(answer(wheels::emergencyStopState).latched()).isFalse();
    assertThat(writing).isNotDone();
  }

  @Test
  void settingAParameterDoesNotWaitForAWrite() throws Exception {
    CompletableFuture<Void> writing = holdUpAWrite(key());
    for (String name : List.of("max_speed", "max_yaw_rate", "command_timeout")) {
      beside(() -> wheels.setParameter(name, "0.2")).get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    }
    assertThat(answer(wheels::attributes)).contains(new DriveAttributes(0.2, 0.2, 0.78, 0.64));
    assertThat(writing).isNotDone();
  }

  @Test
  void aLinkThatIsLostDuringAWriteIsNoticedAtOnceAndTheWriteIsFollowedByAHalt() throws Exception {
    CommandKey key = key();
    CompletableFuture<Void> writing = holdUpAWrite(key);
    beside(() -> wheels.restart(false)).get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    assertThat(answer(wheels::driveState).velocity()).isEqualTo(Velocity.ZERO);
    assertThat(writing).isNotDone();
    wheels.cycleHeldUp = null;
    release.countDown();
    writing.get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    assertThat(wheels.commands).as("it may have reached the new link").endsWith("halt");
    wheels.serveAgain();
    wheels.commands.clear();
    wheels.execute(key, AHEAD);
    await("and the next velocity is watched")
        .atMost(PATIENCE)
        .until(() -> wheels.commands.equals(List.of(TURNED, "halt")));
  }

  @Test
  void releasingTheCommandDoesNotWaitForAWriteThatHangs() throws Exception {
    CommandLease lease = wheels.acquireCommandLease(LEASE);
    CompletableFuture<Void> writing = holdUpAWrite(lease.key());
    beside(lease::close).get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    assertThat(writing).isNotDone();
    assertThat(wheels.commandArbiter().commander()).isNull();
    await("it is halted past the write")
        .atMost(PATIENCE)
        .until(() -> wheels.commands.contains("halt"));
    assertThat(writing).isNotDone();
  }

  @Test
  void takingTheCommandDoesNotWaitForAWriteThatHangsAndTheWheelsStandBeforeTheFirstCommand()
      throws Exception {
    CommandLease first = wheels.acquireCommandLease(LEASE);
    CompletableFuture<Void> writing = holdUpAWrite(first.key());
    beside(first::close).get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    await().atMost(PATIENCE).until(() -> wheels.commands.contains("halt"));
    CompletableFuture<CommandKey> second = new CompletableFuture<>();
    beside(
        () -> {
          try {
            second.complete(key());
          } catch (LeaseRefusedException e) {
            second.completeExceptionally(e);
          }
        });
    CommandKey key = second.get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    assertThat(writing).isNotDone();
    CompletableFuture<Void> released = beside(() -> wheels.execute(key, new Brake(false)));
    wheels.cycleHeldUp = null;
    release.countDown();
    released.get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    writing.get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    List<String> commands = List.copyOf(wheels.commands);
    assertThat(commands.subList(0, 3)).containsExactly(TURNED, "halt", "halt");
    assertThat(commands).endsWith("brake false");
    assertThat(wheels.driveState().velocity()).isEqualTo(Velocity.ZERO);
  }

  /** A client's lease ends, and its callback does not return before the release. */
  private void holdUpTheEndOfALease() throws Exception {
    CountDownLatch noted = new CountDownLatch(1);
    Runnable slow =
        () -> {
          noted.countDown();
          try {
            release.await();
          } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
          }
        };
    wheels.leases().grant(Duration.ofMillis(10), LeaseRole.CLIENT, null, slow);
    assertThat(noted.await(PATIENCE.toSeconds(), TimeUnit.SECONDS)).isTrue();
  }

  @Test
  void aListenerThatIsSlowToNoteTheEndOfALeaseDelaysNoHalt() throws Exception {
    holdUpTheEndOfALease();
    try (StallProbe probe = StallProbe.start()) {
      wheels.execute(key(), AHEAD);
      StallProbe.Stopwatch begun = probe.stopwatch();
      await()
          .pollInterval(Duration.ofMillis(5))
          .atMost(PATIENCE)
          .until(() -> wheels.commands.contains("halt"));
      begun.stop().requireWithin("the halt after the last velocity", HALTED);
    }
    assertThat(wheels.driveState().commandTimeouts()).isEqualTo(1);
  }

  @Test
  void aListenerThatIsSlowToNoteTheEndOfALeaseDelaysNoEndOfACommandersLease() throws Exception {
    holdUpTheEndOfALease();
    CommandKey unused =
        wheels
            .commandArbiter()
            .acquire(
                "a test",
                over ->
                    wheels
                        .leases()
                        .grant(Duration.ofMillis(100), LeaseRole.COMMANDER, null, over)
                        .id());
    await().atMost(PATIENCE).until(() -> wheels.commandArbiter().commander() == null);
    assertThat(wheels.commands).contains("halt");
  }
}
