package org.dfra.river.phoenix;

import static java.util.concurrent.TimeUnit.SECONDS;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.awaitility.Awaitility.await;

import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.MarshalledObject;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationMonitor;
import java.rmi.activation.ActivationSystem;
import java.rmi.activation.UnknownGroupException;
import java.rmi.activation.UnknownObjectException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.dfra.river.phoenix.GroupStatus.State;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Activator, activeGroup and ActivationMonitor: how a group's process comes and goes. */
class GroupLifeTest {

  @TempDir Path temp;
  private final ExecutorService threads = Executors.newCachedThreadPool();
  private final List<FakeGroup> fakes = new ArrayList<>();
  private InVmPhoenix phoenix;
  private ActivationSystem system;
  private ActivationGroupID group;
  private ActivationID object;

  @BeforeEach
  void start() throws Exception {
    phoenix = new InVmPhoenix(temp).start("restartDelay = 1L;");
    system = phoenix.system();
    group = phoenix.group();
    object = phoenix.object(group, false);
  }

  @AfterEach
  void end() {
    phoenix.close();
    fakes.forEach(FakeGroup::close);
    threads.shutdownNow();
  }

  @Test
  void idleGroupIsStartedByTheFirstActivation() throws Exception {
    Future<?> activated = activate(object, false);
    GroupStatus starting = awaitState(State.STARTING);
    assertThat(starting.incarnation()).isEqualTo(1);
    assertThat(ProcessHandle.of(starting.pid())).isPresent();
    FakeGroup fake = fake();
    assertThat(system.activeGroup(group, fake.proxy, 1)).isNotNull();
    assertThat(activated.get()).isEqualTo(fake.proxy);
    assertThat(phoenix.status(0).state()).isEqualTo(State.ACTIVE);
  }

  @Test
  void knownProxyIsGivenWithoutAskingTheGroupUnlessForced() throws Exception {
    FakeGroup fake = active();
    object.activate(false);
    object.activate(false);
    assertThat(fake.made).as("times asked").hasValue(1);
    object.activate(true);
    assertThat(fake.made).as("times asked after force").hasValue(2);
  }

  @Test
  void activeGroupIsIdempotentForTheSameInstantiatorAndIncarnationOnly() throws Exception {
    FakeGroup fake = active();
    ActivationMonitor monitor = system.activeGroup(group, fake.proxy, 1);
    assertThat(monitor).isEqualTo(system.activeGroup(group, fake.proxy, 1));
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> system.activeGroup(group, fake().proxy, 1))
        .withMessage("group 1-group already has an instantiator");
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> system.activeGroup(group, fake.proxy, 2))
        .withMessageContaining("incarnation 2 of group 1-group is refused");
    assertThat(object.activate(true)).as("the first one still works").isEqualTo(fake.proxy);
  }

  @Test
  void groupThatWasNotStartedCannotReport() {
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> system.activeGroup(group, fake().proxy, 0))
        .withMessageContaining("the daemon knows incarnation 0 as IDLE");
  }

  @Test
  void inactiveGroupOfAnotherIncarnationIsUnknown() throws Exception {
    FakeGroup fake = active();
    ActivationMonitor monitor = system.activeGroup(group, fake.proxy, 1);
    for (long wrong : new long[] {0, 2}) {
      assertThatExceptionOfType(UnknownGroupException.class)
          .isThrownBy(() -> monitor.inactiveGroup(group, wrong));
    }
    assertThat(phoenix.status(0).state()).isEqualTo(State.ACTIVE);
    monitor.inactiveGroup(group, 1);
    monitor.inactiveGroup(group, 1); // said twice: no fault
    assertThat(phoenix.status(0).state()).isEqualTo(State.LEAVING);
    system.unregisterGroup(group);
    assertThatExceptionOfType(UnknownGroupException.class)
        .isThrownBy(() -> monitor.inactiveGroup(group, 1));
  }

  @Test
  void inactiveObjectIsMadeAnewAndActiveObjectIsNot() throws Exception {
    FakeGroup fake = active();
    ActivationMonitor monitor = system.activeGroup(group, fake.proxy, 1);
    object.activate(false);
    monitor.inactiveObject(object);
    object.activate(false);
    assertThat(fake.made).as("made after inactiveObject").hasValue(2);

    ActivationID other = phoenix.object(group, false);
    monitor.activeObject(other, new MarshalledObject<>(fake.proxy));
    assertThat(other.activate(false)).isEqualTo(fake.proxy);
    assertThat(fake.made).as("made after activeObject").hasValue(2);

    system.unregisterObject(other);
    assertThatExceptionOfType(UnknownObjectException.class)
        .isThrownBy(() -> monitor.inactiveObject(other));
    assertThatExceptionOfType(UnknownObjectException.class)
        .isThrownBy(() -> monitor.activeObject(other, new MarshalledObject<>(fake.proxy)));
  }

  @Test
  void thirtyTwoThreadsMakeOneInstanceInColdAndLiveGroup() throws Exception {
    for (int round = 0; round < 20; round++) {
      ActivationGroupID cold = phoenix.group();
      ActivationID first = phoenix.object(cold, false);
      ActivationID second = phoenix.object(cold, false);
      FakeGroup fake = fake();
      int index = round + 1;

      List<Future<?>> callers = thirtyTwo(first);
      await("the group's process")
          .atMost(InVmPhoenix.PATIENCE)
          .until(() -> phoenix.status(index).pid() > 0);
      system.activeGroup(cold, fake.proxy, 1);
      for (Future<?> each : callers) {
        assertThat(each.get()).isEqualTo(fake.proxy);
      }
      assertThat(fake.made).as("instances in a cold group, round %s", round).hasValue(1);

      for (Future<?> each : thirtyTwo(second)) {
        each.get();
      }
      assertThat(fake.made).as("instances in a live group, round %s", round).hasValue(2);
      assertThat(phoenix.status(index).incarnation()).isEqualTo(1);
    }
  }

  private List<Future<?>> thirtyTwo(ActivationID id) {
    CyclicBarrier together = new CyclicBarrier(32);
    List<Future<?>> callers = new ArrayList<>();
    for (int i = 0; i < 32; i++) {
      callers.add(
          threads.submit(
              () -> {
                together.await();
                return id.activate(false);
              }));
    }
    return callers;
  }

  @Test
  void killedWhileItStartsTheCallerIsToldAndTheNextActivationWorks() throws Exception {
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

  @Test
  void refusalOfTheGroupReachesTheCallerAtOnce() throws Exception {
    FakeGroup fake = active();
    fake.making =
        () -> {
          throw new ActivationException("its constructor failed");
        };
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> object.activate(false))
        .withMessage("its constructor failed");
    assertThat(fake.made).as("attempts").hasValue(1);
  }

  @Test
  void otherFailuresAreTriedTwiceAndKeepTheirCause() throws Exception {
    FakeGroup fake = active();
    fake.making =
        () -> {
          throw new java.rmi.server.ExportException("played");
        };
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> object.activate(false))
        .withMessageContaining("could not be made in 2 attempts")
        .withMessageContaining("played")
        .withCauseInstanceOf(java.rmi.RemoteException.class);
    assertThat(fake.made).as("attempts").hasValue(2);
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
  void commandThatDoesNotExistIsOneClearSentence() throws Exception {
    ActivationID broken =
        phoenix.object(system.registerGroup(InVmPhoenix.command("/no/such/java")), false);
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> broken.activate(false))
        .withMessageStartingWith("group 2-group cannot be started: Cannot run program")
        .withMessageContaining("/no/such/java")
        .withMessageContaining("mend its command");
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
    phoenix.start("restartLimit = 3; restartHoldOff = 1500L; restartDelay = 1L;");
    ActivationID broken =
        phoenix.object(system.registerGroup(InVmPhoenix.command("/bin/false")), true);
    assertThatExceptionOfType(ActivationException.class).isThrownBy(() -> broken.activate(false));
    await("hold-off")
        .atMost(InVmPhoenix.PATIENCE)
        .until(() -> phoenix.status(1).heldOffUntil() != null);
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
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> broken.activate(false))
        .withMessageContaining("ended (exit code 1)");
    assertThat(phoenix.status(1).incarnation()).as("starts after it").isEqualTo(4);
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
  void onlySoManyGroupsStartAtOnceAsTheThrottleSays() throws Exception {
    phoenix.close();
    phoenix.start("groupThrottle = 2;");
    List<ActivationGroupID> groups = new ArrayList<>();
    for (int i = 0; i < 5; i++) {
      groups.add(phoenix.group());
      activate(phoenix.object(groups.get(i), false), false);
    }
    for (int done = 0; done < 5; done++) {
      int left = Math.min(2, 5 - done);
      await("processes that start").atMost(InVmPhoenix.PATIENCE).until(() -> running() == left);
      GroupStatus first =
          phoenix.admin().groupStatus().stream()
              .filter(s -> s.state() == State.STARTING && s.pid() > 0)
              .findFirst()
              .orElseThrow();
      int index = phoenix.admin().groupStatus().indexOf(first) - 1;
      system.activeGroup(groups.get(index), fake().proxy, 1);
    }
  }

  private long running() throws Exception {
    return phoenix.admin().groupStatus().stream()
        .filter(status -> status.state() == State.STARTING && status.pid() > 0)
        .count();
  }

  @Test
  void groupOptionsOfTheDaemonReachTheCommand() throws Exception {
    phoenix.close();
    phoenix.start("groupOptions = new String[] { \"-Dseen=yes\" };");
    Path script = temp.resolve("args.sh");
    Files.writeString(script, "#!/bin/sh\necho \"$@\"\nexec sleep 300\n");
    Files.setPosixFilePermissions(
        script, Set.of(java.nio.file.attribute.PosixFilePermission.values()));
    activate(
        phoenix.object(system.registerGroup(InVmPhoenix.command(script.toString())), false), false);
    Path output = temp.resolve("journal/output/2-group.vm.log");
    await("the script's output")
        .atMost(InVmPhoenix.PATIENCE)
        .ignoreExceptions()
        .until(() -> Files.readString(output).contains("-Dseen=yes"));
  }

  @Test
  void stoppedProcessesDoNotDelayTheEndEachForItself() throws Exception {
    phoenix.close();
    phoenix.start("unexportTimeout = 1000L;");
    List<Long> pids = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      int index = i + 1;
      activate(phoenix.object(phoenix.group(), false), false);
      await("process").atMost(InVmPhoenix.PATIENCE).until(() -> phoenix.status(index).pid() > 0);
      pids.add(phoenix.status(index).pid());
      new ProcessBuilder("kill", "-STOP", Long.toString(pids.get(i))).start().waitFor();
    }
    long began = System.nanoTime();
    phoenix.close();
    long millis = (System.nanoTime() - began) / 1_000_000;
    assertThat(pids).allSatisfy(pid -> assertThat(ProcessHandle.of(pid)).isEmpty());
    assertThat(millis).as("ms for three stopped processes").isBetween(900L, 2900L);
  }

  @Test
  void shutdownIsAnsweredEndsTheProcessesAndFreesThePort() throws Exception {
    active();
    long pid = phoenix.status(0).pid();
    system.shutdown();
    await("the process ends").atMost(10, SECONDS).until(() -> ProcessHandle.of(pid).isEmpty());
    phoenix.close(); // waits for the end
    assertThatExceptionOfType(java.rmi.RemoteException.class).isThrownBy(system::shutdown);
    phoenix.start();
    assertThat(phoenix.admin().groupStatus()).hasSize(1);
  }

  // What the tests are made of

  private FakeGroup fake() throws java.io.IOException {
    FakeGroup fake = new FakeGroup();
    fakes.add(fake);
    return fake;
  }

  /** The group's first process, started and reported. */
  private FakeGroup active() throws Exception {
    Future<?> activated = activate(phoenix.object(group, false), false);
    long incarnation = awaitState(State.STARTING).incarnation();
    FakeGroup fake = fake();
    system.activeGroup(group, fake.proxy, incarnation);
    activated.get();
    fake.made.set(0);
    return fake;
  }

  private Future<?> activate(ActivationID id, boolean force) {
    CountDownLatch begun = new CountDownLatch(1);
    Callable<Object> call =
        () -> {
          begun.countDown();
          return id.activate(force);
        };
    Future<?> result = threads.submit(call);
    await("the caller").until(() -> begun.getCount() == 0);
    return result;
  }

  private void assertNextActivationWorks(long incarnation) throws Exception {
    Future<?> next = activate(object, true);
    awaitIncarnation(incarnation);
    FakeGroup fake = fake();
    system.activeGroup(group, fake.proxy, incarnation);
    assertThat(next.get()).isEqualTo(fake.proxy);
  }

  private GroupStatus awaitState(State state) {
    return await("group in state " + state)
        .atMost(InVmPhoenix.PATIENCE)
        .until(
            () -> phoenix.status(0),
            status -> status.state() == state && (status.pid() > 0 || state == State.IDLE));
  }

  private GroupStatus awaitIncarnation(long incarnation) {
    return await("process of incarnation " + incarnation)
        .atMost(InVmPhoenix.PATIENCE)
        .until(
            () -> phoenix.status(0),
            status -> status.incarnation() == incarnation && status.pid() > 0);
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
