package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.awaitility.Awaitility.await;

import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationID;
import java.rmi.activation.UnknownGroupException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.river.phoenix.GroupStatus.State;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/**
 * How a group's process ends, and what that leads to: the next start, a restart, a hold-off. The
 * short form has shorter spans, in the same proportions; those of {@code dfra.full} leave more room
 * for a busy computer.
 */
class GroupTerminatorTest extends GroupFixture {

  private static final boolean FULL = Boolean.getBoolean("dfra.full");
  private static final long HOLD_OFF_MILLIS = FULL ? 8000 : 4000;

  /** Of one stopped process; of three, one after the other, it would be three times as long. */
  private static final long UNEXPORT_MILLIS = FULL ? 10_000 : 4000;

  /** Phoenix' three exporters wait for calls under way, for a second each. */
  private static final Duration UNEXPORTED = Duration.ofSeconds(3);

  /** The test polls ten times a second; the remaining time is for the answer. */
  private static final Duration NOTICED = Duration.ofMillis(500);

  private final StallProbe probe = StallProbe.start();

  @AfterEach
  void closeProbe() {
    probe.close();
  }

  @Test
  void killedWhileItStartsTheCallerGetsAnExceptionAndTheNextActivationWorks() throws Exception {
    Future<?> activated = activate(object, false);
    kill(awaitState(State.STARTING));
    assertThatExceptionOfType(ExecutionException.class)
        .isThrownBy(activated::get)
        .withMessageContaining("group 1-group ended (exit code 137); see ");
    assertNextActivationWorks(2);
  }

  @Test
  void killedWhileActiveTheNextActivationWorks() throws Exception {
    active();
    object.activate(false);
    kill(phoenix.status(0));
    assertThat(awaitState(State.IDLE).lastCrash()).isEqualTo("ended (exit code 137)");
    assertNextActivationWorks(2);
  }

  @Test
  void killedWhileItLeavesTheNextActivationWorksAndItIsNoCrash() throws Exception {
    FakeGroup fake = active();
    system.activeGroup(group, fake.proxy, 1).inactiveGroup(group, 1);
    GroupStatus leaving = awaitState(State.LEAVING);
    Future<?> waiting = activate(object, false);
    assertThat(phoenix.status(0).incarnation()).as("no second process beside it").isEqualTo(1);
    kill(leaving);
    FakeGroup next = fake();
    awaitIncarnation(2);
    system.activeGroup(group, next.proxy, 2);
    assertThat(waiting.get()).isEqualTo(next.proxy);
    assertThat(phoenix.status(0).totalCrashes()).isZero();
  }

  @Test
  void processThatSaysItLeavesAndDoesNotIsEnded() throws Exception {
    phoenix.close();
    phoenix.start("unexportTimeout = 1L;");
    FakeGroup fake = active();
    system.activeGroup(group, fake.proxy, 1).inactiveGroup(group, 1);
    awaitState(State.IDLE);
  }

  @Test
  void groupThatMakesNoMoreObjectsIsReplaced() throws Exception {
    FakeGroup fake = active();
    fake.making =
        () -> {
          kill(phoenix);
          throw new InactiveGroupException("no more");
        };
    Future<?> activated = activate(object, false);
    awaitIncarnation(2);
    FakeGroup next = fake();
    system.activeGroup(group, next.proxy, 2);
    assertThat(activated.get()).isEqualTo(next.proxy);
  }

  @Test
  void groupThatCannotBeReachedIsEndedAndReplaced() throws Exception {
    FakeGroup fake = active();
    long pid = phoenix.status(0).pid();
    fake.close();
    Future<?> activated = activate(object, false);
    GroupStatus second = awaitIncarnation(2);
    assertThat(ProcessHandle.of(pid).isPresent() && second.pid() == pid)
        .as("the unreachable process lives")
        .isFalse();
    FakeGroup next = fake();
    system.activeGroup(group, next.proxy, 2);
    assertThat(activated.get()).isEqualTo(next.proxy);
  }

  /** The second attempt finds that nothing listens; the process after it is asked once more. */
  @Test
  void groupThatEndsInTheFirstAttemptIsReplaced() throws Exception {
    FakeGroup fake = active();
    fake.making =
        () -> {
          fake.close();
          throw new RemoteException("lost");
        };
    Future<?> activated = activate(object, false);
    awaitIncarnation(2);
    FakeGroup next = fake();
    system.activeGroup(group, next.proxy, 2);
    assertThat(activated.get()).isEqualTo(next.proxy);
  }

  @Test
  void unregisteredGroupsProcessIsForgottenAndNotKilled() throws Exception {
    active();
    GroupStatus status = phoenix.status(0);
    ProcessHandle process = ProcessHandle.of(status.pid()).orElseThrow();
    try {
      system.unregisterGroup(group);
      assertThat(phoenix.admin().groupStatus()).isEmpty();
      phoenix.close();
      assertThat(process.isAlive()).as("the forgotten group's process").isTrue();
    } finally {
      process.destroyForcibly();
    }
  }

  @Test
  void groupUnregisteredWhileItStartsLeavesAReadableJournal() throws Exception {
    Future<?> activated = activate(object, false);
    GroupStatus starting = awaitState(State.STARTING);
    system.unregisterGroup(group);
    assertThatExceptionOfType(UnknownGroupException.class)
        .isThrownBy(() -> system.activeGroup(group, fake().proxy, 1));
    kill(starting);
    assertThatExceptionOfType(ExecutionException.class).isThrownBy(activated::get);
    phoenix.close();
    phoenix.start();
    assertThat(phoenix.admin().groupStatus()).isEmpty();
  }

  @Test
  void restartSetComesBackByItselfAndTheOthersDoNot() throws Exception {
    active();
    ActivationID restarted = phoenix.object(group, true);
    object.activate(false);
    restarted.activate(false);
    kill(phoenix.status(0));
    awaitIncarnation(2);
    FakeGroup next = fake();
    system.activeGroup(group, next.proxy, 2);
    await("restart").atMost(InVmPhoenix.PATIENCE).until(() -> next.made.get() >= 1);
    assertThat(restarted.activate(false)).isEqualTo(next.proxy);
    assertThat(next.made).as("made: the restarted one only").hasValue(1);
  }

  @Test
  void processThatEndsAtOnceIsReportedAfterOneStart() throws Exception {
    ActivationID broken =
        phoenix.object(system.registerGroup(InVmPhoenix.command("/bin/false")), false);
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> broken.activate(false))
        .withMessageContaining("group 2-group ended (exit code 1); see " + temp);
    assertThat(phoenix.status(1).incarnation()).as("starts for one call").isEqualTo(1);
  }

  @Test
  void crashLoopIsHeldOffSaidAndOverInTime() throws Exception {
    phoenix.close();
    phoenix.start(
        "restartLimit = 3; restartHoldOff = " + HOLD_OFF_MILLIS + "L; restartDelay = 1L;");
    ActivationID broken =
        phoenix.object(system.registerGroup(InVmPhoenix.command("/bin/false")), true);
    assertThatExceptionOfType(ActivationException.class).isThrownBy(() -> broken.activate(false));
    await("hold-off")
        .atMost(InVmPhoenix.PATIENCE)
        .until(() -> phoenix.status(1).heldOffUntil() != null);
    StallProbe.Stopwatch began = probe.stopwatch();
    GroupStatus heldOff = phoenix.status(1);
    assertThat(heldOff.incarnation()).as("starts").isEqualTo(3);
    assertThat(heldOff.recentCrashes()).isEqualTo(3);
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> broken.activate(false))
        .withMessageContaining("crashed 3 times within 60 s and is held off until")
        .withMessageContaining("the last time it ended (exit code 1)");
    assertThat(phoenix.status(1).incarnation()).as("starts while held off").isEqualTo(3);
    await("the end of the hold-off")
        .atMost(InVmPhoenix.PATIENCE)
        .until(() -> phoenix.status(1).heldOffUntil() == null);
    Timing over = began.stop();
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> broken.activate(false))
        .withMessageContaining("ended (exit code 1)");
    assertThat(phoenix.status(1).incarnation()).as("starts after it").isEqualTo(4);
    over.requireWithin("the end of a hold-off", NOTICED.plusMillis(HOLD_OFF_MILLIS));
  }

  @Test
  void groupThatNeverReportsIsEndedAndSaid() throws Exception {
    phoenix.close();
    phoenix.start("groupTimeout = 300L;");
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> object.activate(false))
        .satisfies(
            e ->
                assertThat(e.getMessage())
                    .containsAnyOf("was not ready within 300 ms", "ended (exit code 137)"));
    awaitState(State.IDLE);
  }

  @Test
  void stoppedProcessesDoNotDelayTheEndEachForItself() throws Exception {
    phoenix.close();
    phoenix.start("unexportTimeout = " + UNEXPORT_MILLIS + "L;");
    List<Long> pids = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      int index = i + 1;
      activate(phoenix.object(phoenix.group(), false), false);
      await("process").atMost(InVmPhoenix.PATIENCE).until(() -> phoenix.status(index).pid() > 0);
      pids.add(phoenix.status(index).pid());
      new ProcessBuilder("kill", "-STOP", Long.toString(pids.get(i))).start().waitFor();
    }
    StallProbe.Stopwatch began = probe.stopwatch();
    phoenix.close();
    Timing ended = began.stop();
    assertThat(pids).allSatisfy(pid -> assertThat(ProcessHandle.of(pid)).isEmpty());
    assertThat(ended.took())
        .as("phoenix is patient with stopped processes")
        .isGreaterThan(Duration.ofMillis(UNEXPORT_MILLIS - 100));
    ended.requireWithin(
        "the end of phoenix and of three stopped processes",
        UNEXPORTED.plusMillis(UNEXPORT_MILLIS));
  }

  @Test
  void shutdownIsAnsweredEndsTheProcessesAndFreesThePort() throws Exception {
    active();
    long pid = phoenix.status(0).pid();
    system.shutdown();
    await("the process ends")
        .atMost(InVmPhoenix.PATIENCE)
        .until(() -> ProcessHandle.of(pid).isEmpty());
    phoenix.close(); // waits for the end
    assertThatExceptionOfType(java.rmi.RemoteException.class).isThrownBy(system::shutdown);
    phoenix.start();
    assertThat(phoenix.admin().groupStatus()).hasSize(1);
  }

  private void assertNextActivationWorks(long incarnation) throws Exception {
    Future<?> next = activate(object, true);
    awaitIncarnation(incarnation);
    FakeGroup fake = fake();
    system.activeGroup(group, fake.proxy, incarnation);
    assertThat(next.get()).isEqualTo(fake.proxy);
  }

  private static void kill(InVmPhoenix phoenix) {
    try {
      kill(phoenix.status(0));
    } catch (Exception e) {
      throw new AssertionError(e);
    }
  }

  private static void kill(GroupStatus status) {
    ProcessHandle.of(status.pid()).ifPresent(ProcessHandle::destroyForcibly);
  }
}
