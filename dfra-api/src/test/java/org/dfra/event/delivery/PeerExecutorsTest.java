package org.dfra.event.delivery;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.RejectedExecutionException;
import org.dfra.event.delivery.PeerExecutors.TaskLimits;
import org.junit.jupiter.api.Test;

/** Who may run beside whom; steps by hand, without threads. */
class PeerExecutorsTest {

  /** What the lanes handed to the pool; a task is under way while it lies here. */
  private final Queue<Runnable> pool = new ArrayDeque<>();

  private final List<String> ran = new ArrayList<>();
  private final PeerExecutors lanes = new PeerExecutors(pool::add, new TaskLimits(2, 3, 5));

  private void submit(String peer, String process, String task) {
    lanes.executorFor(peer, process).execute(() -> ran.add(task));
  }

  private void submit(String peer, String process, int count) {
    for (int i = 1; i <= count; i++) {
      submit(peer, process, peer + process + i);
    }
  }

  private void endOne() {
    pool.remove().run();
  }

  private void endAll() {
    while (!pool.isEmpty()) {
      endOne();
    }
  }

  @Test
  void aProcessHasFewTasksUnderWayAndTheOthersWaitInOrder() {
    submit("a", "1", 4);
    assertThat(lanes.runningTasks()).isEqualTo(2);
    assertThat(lanes.waitingTasks()).isEqualTo(2);
    endAll();
    assertThat(ran).containsExactly("a11", "a12", "a13", "a14");
    assertThat(lanes.runningTasks()).isZero();
    assertThat(lanes.waitingTasks()).isZero();
  }

  @Test
  void aPeersProcessesTogetherHaveNoMoreThanThePeerMay() {
    submit("a", "1", 10);
    submit("a", "2", 10);
    assertThat(lanes.runningTasks()).isEqualTo(3);
    submit("b", "1", 1);
    assertThat(pool).as("another peer's begins beside them").hasSize(4);
  }

  @Test
  void allPeersTogetherHaveNoMoreThanAllMay() {
    for (String peer : List.of("a", "b", "c", "d")) {
      submit(peer, "1", 2);
    }
    assertThat(lanes.runningTasks()).isEqualTo(5);
    endOne();
    assertThat(lanes.runningTasks()).as("the next one begins").isEqualTo(5);
    endAll();
    assertThat(ran).hasSize(8);
  }

  @Test
  void aPeerThatNeverEndsHoldsUpNoOther() {
    submit("silent", "1", 100);
    submit("silent", "2", 100);
    List<Runnable> hanging = new ArrayList<>(pool); // these never end
    pool.clear();
    assertThat(hanging).hasSize(3);
    submit("honest", "1", 50);
    endAll();
    assertThat(ran).hasSize(50).allMatch(task -> task.startsWith("honest"));
  }

  @Test
  void lanesTakeTurns() {
    PeerExecutors one = new PeerExecutors(pool::add, new TaskLimits(1, 1, 1));
    for (int i = 1; i <= 3; i++) {
      String task = "a" + i;
      one.executorFor("a", "1").execute(() -> ran.add(task));
    }
    one.executorFor("b", "1").execute(() -> ran.add("b1"));
    endAll();
    assertThat(ran).containsExactly("a1", "a2", "b1", "a3");
  }

  @Test
  void aTaskThatFailsFreesItsPlace() {
    lanes
        .executorFor("a", "1")
        .execute(
            () -> {
              throw new IllegalStateException("as a listener may");
            });
    assertThatThrownBy(this::endOne).isInstanceOf(IllegalStateException.class);
    assertThat(lanes.runningTasks()).isZero();
    submit("a", "1", 2);
    endAll();
    assertThat(ran).hasSize(2);
  }

  @Test
  void aTaskThatThePoolRefusesFreesItsPlace() {
    PeerExecutors refused =
        new PeerExecutors(
            task -> {
              throw new RejectedExecutionException("closed");
            },
            new TaskLimits(1, 1, 1));
    assertThatThrownBy(() -> refused.executorFor("a", "1").execute(() -> {}))
        .isInstanceOf(RejectedExecutionException.class);
    assertThat(refused.runningTasks()).isZero();
  }

  @Test
  void limitsThatCannotBeKeptAreRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new TaskLimits(2, 1, 5))
        .withMessage("limits must be 1 <= perProcess 2 <= perPeer 1 <= inAll 5");
  }
}
