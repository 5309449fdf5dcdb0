package org.dfra.river.phoenix;

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
import java.rmi.activation.UnknownGroupException;
import java.rmi.activation.UnknownObjectException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.Future;
import org.dfra.river.phoenix.GroupStatus.State;
import org.junit.jupiter.api.Test;

/** Activator, activeGroup and ActivationMonitor: how a group's process comes and makes objects. */
class GroupLifeTest extends GroupFixture {

  private static final int ROUNDS = Boolean.getBoolean("dfra.full") ? 20 : 5;

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
        .withMessageContaining("phoenix knows incarnation 0 as IDLE");
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
  void inactiveObjectIsCreatedAgainAndActiveObjectIsNot() throws Exception {
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
    for (int round = 0; round < ROUNDS; round++) {
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
        .withMessageContaining("could not be created in 2 attempts")
        .withMessageContaining("played")
        .withCauseInstanceOf(java.rmi.RemoteException.class);
    assertThat(fake.made).as("attempts").hasValue(2);
  }

  @Test
  void commandThatDoesNotExistIsOneClearSentence() throws Exception {
    ActivationID broken =
        phoenix.object(system.registerGroup(InVmPhoenix.command("/no/such/java")), false);
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> broken.activate(false))
        .withMessageStartingWith("group 2-group cannot be started: Cannot run program")
        .withMessageContaining("/no/such/java")
        .withMessageContaining("correct its command");
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

  /** Whatever keeps this process from opening a connection proves nothing of the other one. */
  @Test
  void groupThatCannotBeConnectedToForWantOfDescriptorsIsLeftAlive() throws Exception {
    Future<?> first = activate(phoenix.object(group, false), false);
    long pid = awaitState(State.STARTING).pid();
    system.activeGroup(group, new Unconnectable(), 1);
    assertThatExceptionOfType(java.util.concurrent.ExecutionException.class)
        .isThrownBy(first::get)
        .withStackTraceContaining("Too many open files");
    assertThat(ProcessHandle.of(pid)).as("the group's process").isPresent();
    assertThat(phoenix.status(0).pid()).isEqualTo(pid);
    assertThat(phoenix.status(0).totalCrashes()).isZero();
  }

  /** An instantiator whose process may open no more files. */
  private record Unconnectable()
      implements java.rmi.activation.ActivationInstantiator, java.io.Serializable {
    @Override
    public MarshalledObject<? extends java.rmi.Remote> newInstance(
        ActivationID id, java.rmi.activation.ActivationDesc desc)
        throws java.rmi.ConnectIOException {
      throw new java.rmi.ConnectIOException(
          "I/O exception connecting", new java.net.SocketException("Too many open files"));
    }
  }

  @Test
  void whatIsActiveIsReportedWithoutStartingAnything() throws Exception {
    assertThat(phoenix.admin().activeProxy(object)).isNull();
    assertThat(phoenix.admin().activeObjects(group)).isEmpty();
    assertThat(phoenix.status(0).state()).isEqualTo(State.IDLE);

    FakeGroup fake = active();
    assertThat(phoenix.admin().activeProxy(object)).as("another one is").isNull();
    object.activate(false);
    assertThat(phoenix.admin().activeProxy(object).get()).isEqualTo(fake.proxy);
    assertThat(phoenix.admin().activeObjects(group)).hasSize(2).contains(object);
    assertThat(fake.made).as("times asked").hasValue(1);
  }

  @Test
  void onlyAnInactiveObjectIsUnregistered() throws Exception {
    FakeGroup fake = active();
    object.activate(false);
    assertThat(phoenix.admin().unregisterInactive(object)).isFalse();
    assertThat(object.activate(false)).isEqualTo(fake.proxy);

    system.activeGroup(group, fake.proxy, 1).inactiveObject(object);
    assertThat(phoenix.admin().unregisterInactive(object)).isTrue();
    assertThatExceptionOfType(UnknownObjectException.class)
        .isThrownBy(() -> object.activate(false));
    assertThatExceptionOfType(UnknownObjectException.class)
        .isThrownBy(() -> phoenix.admin().unregisterInactive(object));
  }

  @Test
  void anObjectThatIsBeingMadeIsAwaitedBeforeItIsSaidToBeInactive() throws Exception {
    FakeGroup fake = active();
    CyclicBarrier making = new CyclicBarrier(2);
    fake.making = () -> meet(making);
    Future<?> activated = activate(object, false);
    await("it is being made").atMost(InVmPhoenix.PATIENCE).until(() -> fake.made.get() == 1);
    Future<Boolean> unregistered = threads.submit(() -> phoenix.admin().unregisterInactive(object));
    meet(making);
    assertThat(activated.get()).isEqualTo(fake.proxy);
    assertThat(unregistered.get()).as("it was made").isFalse();
  }

  private static void meet(CyclicBarrier barrier) throws ActivationException {
    try {
      barrier.await();
    } catch (InterruptedException | java.util.concurrent.BrokenBarrierException e) {
      throw new ActivationException("the test is over", e);
    }
  }
}
