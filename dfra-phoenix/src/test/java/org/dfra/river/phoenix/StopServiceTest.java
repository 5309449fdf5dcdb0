package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.rmi.RemoteException;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Future;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.river.phoenix.GroupStatus.State;
import org.dfra.river.phoenix.stop.EffectorStopResult;
import org.dfra.river.phoenix.stop.GroupStopResult;
import org.dfra.river.phoenix.stop.StopReport;
import org.dfra.river.phoenix.stop.UnconfirmedGroup;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Phoenix forwards a stop to all groups at once, and says which of them have confirmed. */
@Timeout(120)
class StopServiceTest extends GroupFixture {

  private static final UUID ID = new UUID(1, 2);
  private static final EmergencyStopState STOPPED =
      new EmergencyStopState(true, "ops", Instant.parse("2026-11-21T12:00:00Z"), true, null);

  private final CountDownLatch goesOn = new CountDownLatch(1);

  @AfterEach
  void goOn() {
    goesOn.countDown();
  }

  private static EffectorStopResult stop(String path) {
    return new EffectorStopResult(ID, path, false, STOPPED, null);
  }

  private static GroupStopResult answer(ActivationID object, String path) {
    return new GroupStopResult(
        List.of(new GroupStopResult.EffectorAnswer(object, stop(path))), List.of());
  }

  /** A group with a name and one object, whose process has reported. */
  private FakeGroup active(String name, ActivationGroupID id, ActivationID its, int index)
      throws Exception {
    Future<?> activated = activate(its, false);
    long incarnation =
        await(name)
            .atMost(InVmPhoenix.PATIENCE)
            .until(
                () -> phoenix.status(index),
                each -> each.state() == State.STARTING && each.pid() > 0)
            .incarnation();
    FakeGroup fake = fake();
    system.activeGroup(id, fake.proxy, incarnation);
    activated.get();
    return fake;
  }

  private GroupStopResult hang() throws RemoteException {
    try {
      goesOn.await();
    } catch (InterruptedException e) {
      throw new RemoteException("interrupted", e);
    }
    return GroupStopResult.NONE;
  }

  @Test
  void aGroupThatDoesNotAnswerIsUnconfirmedAndDelaysNoOther() throws Exception {
    ActivationGroupID mute = phoenix.group("eta.mute");
    ActivationID inMute = phoenix.object(mute, false);
    FakeGroup first = active("eta.mute", mute, inMute, 1);
    ActivationGroupID wheels = phoenix.group("eta.wheels");
    ActivationID drive = phoenix.object(wheels, false);
    FakeGroup second = active("eta.wheels", wheels, drive, 2);
    first.stopping = by -> hang();
    second.stopping = by -> answer(drive, "eta/drive");

    StopReport report = phoenix.stopService().emergencyStop(List.of("eta"), "ops");

    assertThat(report.robots()).containsExactly("eta");
    assertThat(report.effectors()).containsExactly(stop("eta/drive"));
    assertThat(report.unconfirmed())
        .singleElement()
        .returns("eta", UnconfirmedGroup::robot)
        .returns("eta.mute", UnconfirmedGroup::group)
        .satisfies(each -> assertThat(each.reason()).startsWith("its process did not answer"));
    assertThat(phoenix.status(1).state()).as("it is not killed").isEqualTo(State.ACTIVE);
  }

  @Test
  void aStopDoesNotWaitForTheLaunchOfItsGroup() throws Exception {
    phoenix.close();
    phoenix.start("groupThrottle = 1;");
    Future<?> unused = activate(object, false);
    GroupStatus starting = awaitState(State.STARTING); // it has the only launch permit
    ActivationGroupID wheels = phoenix.group("eta.wheels");
    Future<?> waiting = activate(phoenix.object(wheels, false), false);
    await("the launch that waits for a permit")
        .atMost(InVmPhoenix.PATIENCE)
        .until(() -> phoenix.status(1).state() == State.STARTING);

    StopReport report = phoenix.stopService().emergencyStop(List.of("eta"), "ops");

    assertThat(report.unconfirmed())
        .singleElement()
        .returns("eta.wheels", UnconfirmedGroup::group)
        .returns(
            "1 of its effectors did not run; phoenix starts them to stop them",
            UnconfirmedGroup::reason);
    assertThat(phoenix.status(0)).as("it still has the permit").isEqualTo(starting);
    assertThat(phoenix.status(1).pid()).as("the launch still waits").isEqualTo(-1);
    assertThat(waiting).isNotDone();
  }

  @Test
  void onlyTheRobotsThatAreNamedAreStopped() throws Exception {
    ActivationGroupID eta = phoenix.group("eta.wheels");
    FakeGroup itsGroup = active("eta.wheels", eta, phoenix.object(eta, false), 1);
    ActivationGroupID theta = phoenix.group("theta.wheels");
    FakeGroup otherGroup = active("theta.wheels", theta, phoenix.object(theta, false), 2);

    StopReport report = phoenix.stopService().emergencyStop(List.of("eta", "nobody"), null);

    assertThat(report.robots()).containsExactly("eta", "theta");
    assertThat(itsGroup.ordered.get()).isPositive();
    assertThat(otherGroup.ordered).hasValue(0);
  }

  @Test
  void anEffectorThatDoesNotRunIsStartedAndThenStopped() throws Exception {
    ActivationGroupID wheels = phoenix.group("eta.wheels");
    ActivationID drive = phoenix.object(wheels, false);
    ActivationID sleeping = phoenix.object(wheels, false);
    FakeGroup fake = active("eta.wheels", wheels, drive, 1);
    fake.made.set(0);
    fake.stopping =
        by ->
            fake.made.get() == 0
                ? answer(drive, "eta/drive")
                : new GroupStopResult(
                    List.of(
                        new GroupStopResult.EffectorAnswer(drive, stop("eta/drive")),
                        new GroupStopResult.EffectorAnswer(sleeping, stop("eta/head"))),
                    List.of());

    StopReport first = phoenix.stopService().emergencyStop(List.of(), "ops");
    assertThat(first.unconfirmed()).extracting(UnconfirmedGroup::group).contains("eta.wheels");
    await()
        .atMost(InVmPhoenix.PATIENCE)
        .untilAsserted(
            () ->
                assertThat(phoenix.stopService().emergencyStop(List.of("eta"), "ops"))
                    .returns(List.of(), StopReport::unconfirmed)
                    .returns(List.of(stop("eta/drive"), stop("eta/head")), StopReport::effectors));
  }

  @Test
  void howeverManyCallThereIsOneOrderUnderWayAndOneThatWaits() throws Exception {
    ActivationGroupID wheels = phoenix.group("eta.wheels");
    ActivationID drive = phoenix.object(wheels, false);
    FakeGroup fake = active("eta.wheels", wheels, drive, 1);
    fake.stopping =
        by -> {
          GroupStopResult unused = hang();
          return answer(drive, "eta/drive");
        };
    List<Future<StopReport>> calls = new ArrayList<>();
    for (int i = 0; i < 10; i++) {
      calls.add(threads.submit(() -> phoenix.stopService().emergencyStop(List.of("eta"), "ops")));
    }
    for (Future<StopReport> call : calls) {
      assertThat(call.get().unconfirmed()).hasSize(1);
    }
    assertThat(fake.ordered).hasValue(1);
    goesOn.countDown();
    await().atMost(InVmPhoenix.PATIENCE).until(() -> fake.ordered.get() == 2);
    assertThat(phoenix.stopService().emergencyStop(List.of("eta"), "ops").effectors())
        .containsExactly(stop("eta/drive"));
    assertThat(fake.ordered.get()).isLessThanOrEqualTo(3);
  }
}
