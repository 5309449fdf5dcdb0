package org.dfra.river.phoenix;

import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationSystem;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.dfra.river.phoenix.GroupStatus.State;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** A phoenix with one group, whose processes the test plays, and one object in it. */
abstract class GroupFixture {

  @TempDir Path temp;
  final ExecutorService threads = Executors.newCachedThreadPool();
  final List<FakeGroup> fakes = new ArrayList<>();
  InVmPhoenix phoenix;
  ActivationSystem system;
  ActivationGroupID group;
  ActivationID object;

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

  /** A group that the test plays; it has not reported yet. */
  FakeGroup fake() throws java.io.IOException {
    FakeGroup fake = new FakeGroup();
    fakes.add(fake);
    return fake;
  }

  /** The group's first process, started and reported. */
  FakeGroup active() throws Exception {
    Future<?> activated = activate(phoenix.object(group, false), false);
    long incarnation = awaitState(State.STARTING).incarnation();
    FakeGroup fake = fake();
    system.activeGroup(group, fake.proxy, incarnation);
    activated.get();
    fake.made.set(0);
    return fake;
  }

  /** Activates an object on a thread of its own, which has begun when this returns. */
  Future<?> activate(ActivationID id, boolean force) {
    CountDownLatch begun = new CountDownLatch(1);
    Callable<Object> call =
        () -> {
          begun.countDown();
          return id.activate(force);
        };
    Future<?> result = threads.submit(call);
    await("the caller").atMost(InVmPhoenix.PATIENCE).until(() -> begun.getCount() == 0);
    return result;
  }

  /** Waits for the first group to be in a state, with a process where it has one. */
  GroupStatus awaitState(State state) {
    return await("group in state " + state)
        .atMost(InVmPhoenix.PATIENCE)
        .until(
            () -> phoenix.status(0),
            status -> status.state() == state && (status.pid() > 0 || state == State.IDLE));
  }

  /** Waits for the process of an incarnation of the first group. */
  GroupStatus awaitIncarnation(long incarnation) {
    return await("process of incarnation " + incarnation)
        .atMost(InVmPhoenix.PATIENCE)
        .until(
            () -> phoenix.status(0),
            status -> status.incarnation() == incarnation && status.pid() > 0);
  }
}
